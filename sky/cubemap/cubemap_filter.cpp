// SPDX-License-Identifier: Apache-2.0
#include "sky/cubemap/cubemap_filter.h"

#include <algorithm>
#include <cmath>

namespace welkin::cubemap {
namespace {

/// A direction on its face: s along columns, t along rows, in [-1, 1].
struct OnFace {
  int face;
  double s, t;
};

OnFace faceOf(const Number3& d) {
  const double x = std::abs(d.x);
  const double y = std::abs(d.y);
  const double z = std::abs(d.z);
  const int axis = z >= x && z >= y ? 2 : y >= x ? 1 : 0;
  const int face = 2 * axis + (d[axis] < 0.0 ? 1 : 0);
  const FaceAxes axes = faceAxes(Layout::vulkan_cube, face);
  const double along = dot(d, axes.normal);
  return {face, dot(d, axes.right) / along, dot(d, axes.down) / along};
}

double centreOf(int size, int i) {
  return (2.0 * i + 1.0) / size - 1.0;
}

std::size_t indexOf(int size, int face, int column, int row) {
  return (static_cast<std::size_t>(face) * static_cast<std::size_t>(size) + static_cast<std::size_t>(row)) *
             static_cast<std::size_t>(size) +
         static_cast<std::size_t>(column);
}

/// The texel beside a face's edge, of the face there: the one whose square the centre, put past the edge, looks into.
std::size_t indexAcross(int size, int face, int column, int row) {
  const FaceAxes axes = faceAxes(Layout::vulkan_cube, face);
  const OnFace at = faceOf(axes.normal + axes.right * centreOf(size, column) + axes.down * centreOf(size, row));
  const auto texel = [&](double coordinate) {
    return std::clamp(static_cast<int>((0.5 * coordinate + 0.5) * size), 0, size - 1);
  };
  return indexOf(size, at.face, texel(at.s), texel(at.t));
}

}  // namespace

Footprint footprintOf(int size, const Number3& direction) {
  const OnFace at = faceOf(direction);
  const double u = (0.5 * at.s + 0.5) * size - 0.5;
  const double v = (0.5 * at.t + 0.5) * size - 0.5;
  const double left = std::floor(u);
  const double top = std::floor(v);
  const double across = u - left;
  const double down = v - top;
  Footprint footprint{};
  int missing = -1;
  for (int k = 0; k < 4; ++k) {
    const int column = static_cast<int>(left) + k % 2;
    const int row = static_cast<int>(top) + k / 2;
    const bool past_column = column < 0 || column >= size;
    const bool past_row = row < 0 || row >= size;
    auto& share = footprint[static_cast<std::size_t>(k)];
    share.weight = (k % 2 == 1 ? across : 1.0 - across) * (k / 2 == 1 ? down : 1.0 - down);
    if (past_column && past_row)
      missing = k;
    else if (past_column || past_row)
      share.texel = indexAcross(size, at.face, column, row);
    else
      share.texel = indexOf(size, at.face, column, row);
  }
  if (missing < 0) return footprint;
  auto& none = footprint[static_cast<std::size_t>(missing)];
  for (auto& share : footprint)
    if (&share != &none) share.weight += none.weight / 3.0;
  none = {footprint[static_cast<std::size_t>(3 - missing)].texel, 0.0};
  return footprint;
}

Number3 directionOfTexel(int size, std::size_t texel) {
  const auto n = static_cast<std::size_t>(size);
  return directionOfTexel(Layout::vulkan_cube, size, static_cast<int>(texel % n), static_cast<int>(texel / n));
}

Number3 filterTexels(const unsigned char* texels, format::CubemapFormat format, const Footprint& footprint) {
  const std::size_t bytes = format::texelBytes(format);
  Number3 sum(0.0);
  for (const TexelShare& share : footprint) {
    float rgb[3];
    format::decodeTexel(format, texels + share.texel * bytes, rgb);
    sum += Number3(double{rgb[0]}, double{rgb[1]}, double{rgb[2]}) * share.weight;
  }
  return sum;
}

}  // namespace welkin::cubemap
