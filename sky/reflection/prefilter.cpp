// SPDX-License-Identifier: Apache-2.0
#include "sky/reflection/prefilter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sky/cubemap/cubemap.h"
#include "sky/reflection/lobe.h"

namespace welkin::reflection {
namespace {

constexpr double kShareThatEnds = 1e-5;
constexpr double kTexelsInWidth = 2.0;
constexpr int kLeastSize = 128;
constexpr int kBlock = 4;          // texels along an edge of a block that is summed without a further look
constexpr int kTableSteps = 4096;  // linear between: w falls by e^11.5 over them, so 1e-6 of its peak

/// Coarsest level whose texels, 2/size wide at a face's middle, are fine enough.
std::size_t levelFor(const CubePyramid& pyramid, double power) {
  const double size = std::max(kTexelsInWidth * 2.0 / lobeWidth(power), static_cast<double>(kLeastSize));
  std::size_t level = 1;  // the largest mip has no halves
  while (level + 1 < pyramid.levels().size() && pyramid.levels()[level + 1].size >= size) ++level;
  return level;
}

}  // namespace

/// The sum so far, on one face: the axis in the face's frame.
struct Prefilter::Gathering {
  double right, down, normal;
  std::size_t face;
  double rgb[3];
  double weight;
};

Prefilter::Prefilter(const CubePyramid& pyramid, double power)
    : pyramid_(pyramid), level_(levelFor(pyramid, power)), reach_(lobeReach(power, kShareThatEnds)) {
  const double range = 1.0 - reach_;
  steps_ = kTableSteps / range;
  for (int i = 0; i <= kTableSteps; ++i) slopes_.push_back(lobeSlopes(power, 1.0 - range * i / kTableSteps));
  slopes_.push_back(slopes_.back());
  const double angle = std::acos(reach_);
  for (const CubeLevel& level : pyramid.levels()) {
    // A texel's corner is no further from its centre than asin(sqrt(2)/size), seen from 1 or more away.
    const double radius = level.size > 1 ? std::asin(std::sqrt(2.0) / level.size) : det::kPi;
    near_cosine_.push_back(angle + radius < det::kPi ? std::cos(angle + radius) : -1.0);
  }
}

// Over a texel h wide in (s, t), with c the cosine, n the axis along the normal, q = 1/|(s, t, 1)| and e = n - c q, the
// mean of the lobe by solid angle is, to fourth order,
//   w + h^2/24 q^2 (w'' (1 - c^2 - e^2) + w' (8 e q - c (1 + q^2))),
// from |grad c|^2 = q^2 (1 - c^2 - e^2), c_ss + c_tt = q^2 (2 e q - c - c q^2) and the density q^3 of solid angle.
// A slope of light along s adds h^2/12 times its product with dw/ds = w' q (a - c q s), where a is the axis along s.
void Prefilter::gatherTexels(Gathering& sum, int row, int column) const {
  const CubeLevel& level = pyramid_.levels()[level_];
  const double h = 2.0 / level.size, limit = 1.0 - reach_, bend = h * h / 24.0, lean = h / 6.0;
  const auto size = static_cast<std::size_t>(level.size);
  for (int y = row; y < row + kBlock; ++y) {
    const double t = (y + 0.5) * h - 1.0, across = sum.normal + sum.down * t;
    const std::size_t line = static_cast<std::size_t>(y) * size;
    const std::size_t stacked = sum.face * size * size + line;
    for (int x = column; x < column + kBlock; ++x) {
      const std::size_t at = static_cast<std::size_t>(x);
      const double s = (x + 0.5) * h - 1.0, q = level.inverse_norm[line + at];
      const double cosine = (across + sum.right * s) * q, from_axis = std::max(1.0 - cosine, 0.0);
      if (from_axis >= limit) continue;
      const double place = from_axis * steps_;
      const auto first = static_cast<std::size_t>(place);
      const double part = place - static_cast<double>(first);
      const LobeSlopes &low = slopes_[first], &high = slopes_[first + 1];
      const double w = low.value + part * (high.value - low.value), dw = low.first + part * (high.first - low.first),
                   ddw = low.second + part * (high.second - low.second);
      const double solid_angle = level.solid_angle[line + at], tilt = cosine * q, e = sum.normal - tilt;
      const double weight =
          solid_angle *
          (w + bend * q * q * (ddw * (1.0 - cosine * cosine - e * e) + dw * (8.0 * e * q - cosine * (1.0 + q * q))));
      const double slope = solid_angle * lean * dw * q;
      const double slope_s = slope * (sum.right - tilt * s), slope_t = slope * (sum.down - tilt * t);
      for (std::size_t c = 0, i = 3 * (stacked + at); c < 3; ++c, ++i)
        sum.rgb[c] +=
            weight * double{level.rgb[i]} + slope_s * double{level.along_s[i]} + slope_t * double{level.along_t[i]};
      sum.weight += weight;
    }
  }
}

void Prefilter::gather(Gathering& sum, std::size_t level, int row, int column) const {
  const CubeLevel& texels = pyramid_.levels()[level];
  const double s = (2 * column + 1.0) / texels.size - 1.0, t = (2 * row + 1.0) / texels.size - 1.0;
  const double norm = texels.inverse_norm[static_cast<std::size_t>(row) * static_cast<std::size_t>(texels.size) +
                                          static_cast<std::size_t>(column)];
  if ((sum.normal + sum.right * s + sum.down * t) * norm < near_cosine_[level]) return;
  if (pyramid_.levels()[level_].size == kBlock * texels.size) {
    gatherTexels(sum, kBlock * row, kBlock * column);
    return;
  }
  for (int k = 0; k < 4; ++k) gather(sum, level - 1, 2 * row + k / 2, 2 * column + k % 2);
}

Number3 Prefilter::at(const Number3& axis) const {
  Gathering sum{};
  const std::size_t coarsest = pyramid_.levels().size() - 1;
  for (int face = 0; face < 6; ++face) {
    const cubemap::FaceAxes axes = cubemap::faceAxes(cubemap::Layout::vulkan_cube, face);
    sum.right = dot(axis, axes.right);
    sum.down = dot(axis, axes.down);
    sum.normal = dot(axis, axes.normal);
    sum.face = static_cast<std::size_t>(face);
    for (int k = 0; k < 4; ++k) gather(sum, coarsest, k / 2, k % 2);
  }
  return Number3(sum.rgb[0], sum.rgb[1], sum.rgb[2]) / sum.weight;
}

}  // namespace welkin::reflection
