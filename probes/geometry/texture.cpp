// SPDX-License-Identifier: Apache-2.0
#include "probes/geometry/texture.h"

#include <algorithm>
#include <array>

#include "sh/deterministic.h"

namespace welkin::geometry {
namespace {

/// Linear value of every sRGB byte.
const std::array<double, 256>& linearOfByte() {
  static const auto table = [] {
    std::array<double, 256> linear{};
    for (std::size_t i = 0; i < linear.size(); ++i) linear[i] = det::srgbDecode(static_cast<double>(i) / 255.0);
    return linear;
  }();
  return table;
}

int wrapped(double texel, int count, Texture::Wrap wrap) {
  if (wrap == Texture::Wrap::clamped) return static_cast<int>(std::clamp(texel, 0.0, count - 1.0));
  const double period = wrap == Texture::Wrap::mirrored ? 2.0 * count : count;
  const int i = static_cast<int>(std::clamp(texel - std::floor(texel / period) * period, 0.0, period - 1.0));
  return i < count ? i : 2 * count - 1 - i;
}

}  // namespace

Texel texelAt(const Texture& texture, double u, double v) {
  if (texture.rgba.empty()) return {Number3(1.0), 1.0};
  const double x = u * texture.width - 0.5;
  const double y = v * texture.height - 0.5;
  const double left = std::floor(x);
  const double top = std::floor(y);
  const auto& linear = linearOfByte();
  Texel sum{Number3(0.0), 0.0};
  for (const int dy : {0, 1})
    for (const int dx : {0, 1}) {
      const auto column = static_cast<std::size_t>(wrapped(left + dx, texture.width, texture.wrap_u));
      const auto row = static_cast<std::size_t>(wrapped(top + dy, texture.height, texture.wrap_v));
      const std::uint8_t* p = texture.rgba.data() + 4 * (row * static_cast<std::size_t>(texture.width) + column);
      const double weight = (dx == 1 ? x - left : 1.0 - (x - left)) * (dy == 1 ? y - top : 1.0 - (y - top));
      sum.colour += Number3(linear[p[0]], linear[p[1]], linear[p[2]]) * weight;
      sum.alpha += p[3] / 255.0 * weight;
    }
  return sum;
}

}  // namespace welkin::geometry
