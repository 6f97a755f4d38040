// SPDX-License-Identifier: Apache-2.0
// Normal maps of a height that tiles, for tests.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "gloss/normal_map.h"
#include "sh/deterministic.h"

namespace welkin::tests {

/// Unit normal of the height at a place of the tile, x right and y up, both in [0, 1).
inline det::Number3 bumpNormal(double x, double y, double steepness) {
  const double u = det::kTwoPi * x, v = det::kTwoPi * y;
  const double right = steepness * (std::cos(u + 2.0 * v) + std::cos(3.0 * u - v) + 0.5 * std::cos(5.0 * u + 4.0 * v));
  const double up =
      steepness * (2.0 * std::cos(u + 2.0 * v) - std::cos(3.0 * u - v) / 3.0 + 0.4 * std::cos(5.0 * u + 4.0 * v));
  const det::Number3 n{-right, -up, 1.0};
  return n / std::sqrt(dot(n, n));
}

/// The codes (n + 1)/2 of bumps, without rounding.
inline image::Image bumpCodes(int width, int height, double steepness) {
  image::Image image;
  image.width = width;
  image.height = height;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const det::Number3 n = bumpNormal((column + 0.5) / width, 1.0 - (row + 0.5) / height, steepness);
      for (int c = 0; c < 3; ++c) image.rgb.push_back(static_cast<float>((n[c] + 1.0) / 2.0));
    }
  return image;
}

inline gloss::NormalMap bumps(int width, int height, double steepness) {
  return gloss::normalMapOf("bumps", bumpCodes(width, height, steepness), {});
}

/// The codes rounded to 8 bits.
inline image::Image rounded(image::Image image) {
  for (float& v : image.rgb) v = std::round(v * 255.0F) / 255.0F;
  return image;
}

}  // namespace welkin::tests
