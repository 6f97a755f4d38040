// SPDX-License-Identifier: Apache-2.0
// The highlight of a bumpy surface in pixels that hold many texels, against the mean over the texels themselves.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "gloss/mips.h"
#include "materials.h"

namespace welkin::tests {

/// Normals whose slopes are independent and normal, of so wide a deviation.
inline gloss::NormalMap gaussianBumps(int size, double deviation) {
  std::mt19937 random(3);
  std::normal_distribution<double> slope(0.0, deviation);
  gloss::NormalMap map;
  map.width = map.height = size;
  for (int i = 0; i < size * size; ++i) {
    const double x = slope(random), y = slope(random), length = std::sqrt(x * x + y * y + 1.0);
    for (const double v : {-x / length, -y / length, 1.0 / length}) map.xyz.push_back(static_cast<float>(v));
  }
  return map;
}

/// How pixels of a mip show the highlight, over half vectors around the surface's normal.
struct Highlight {
  double energy = 0.0;  ///< all light over the truth's
  double error = 0.0;   ///< sum of the differences' sizes over the truth: 0 for the same shape in every pixel
};

/// `power` gives a pixel's specular power by its place in the mip. The mip's texels cover `side` x `side` of mip 0.
template <typename Power>
Highlight highlightOf(const gloss::NormalMap& map, double m, const gloss::Mip& mip, int side, Power&& power) {
  using f64::Number3;
  const auto normalAt = [](const std::vector<float>& n, std::size_t i) {
    return Number3(double{n[3 * i]}, double{n[3 * i + 1]}, double{n[3 * i + 2]});
  };
  constexpr int kAngles = 24;  // half vectors from the normal to 0.6 rad, in a plane
  double shown = 0.0, truth = 0.0, error = 0.0;
  for (int j = 0; j < kAngles; ++j) {
    const double angle = 0.6 * (j + 0.5) / kAngles;
    const Number3 h{std::sin(angle), 0.0, std::cos(angle)};
    for (std::size_t pixel = 0; pixel < mip.gloss.size(); ++pixel) {
      const int left = static_cast<int>(pixel) % mip.width * side, top = static_cast<int>(pixel) / mip.width * side;
      double mean = 0.0;
      for (int y = top; y < top + side; ++y)
        for (int x = left; x < left + side; ++x) {
          const double cosine = dot(normalAt(map.xyz, static_cast<std::size_t>(y * map.width + x)), h);
          mean += f64::blinnPhong(m, std::max(cosine, 0.0)) / (side * side);
        }
      const double value = f64::blinnPhong(power(pixel), std::max(dot(normalAt(mip.normal, pixel), h), 0.0));
      shown += std::sin(angle) * value;
      truth += std::sin(angle) * mean;
      error += std::sin(angle) * std::abs(value - mean);
    }
  }
  return {shown / truth, error / truth};
}

}  // namespace welkin::tests
