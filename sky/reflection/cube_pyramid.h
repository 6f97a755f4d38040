// SPDX-License-Identifier: Apache-2.0
// A cube of radiance and its mips, each the mean over solid angle of the one before, in Vulkan's orientation.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "sh/deterministic.h"

namespace welkin::reflection {

using det::Number3;

/// Radiance in a unit direction of Welkin's world. Called from many threads.
using Radiance = std::function<Number3(const Number3&)>;

/// One mip.
struct CubeLevel {
  int size = 0;                      ///< texels along a face's edge
  std::vector<float> rgb;            ///< faces +x -x +y -y +z -z, row after row
  std::vector<float> along_s;        ///< of each: the right half's mean less the left half's; none in the largest mip
  std::vector<float> along_t;        ///< of each: the lower half's mean less the upper half's; none in the largest mip
  std::vector<double> solid_angle;   ///< sr, of a face's texels; the six faces have the same ones
  std::vector<double> inverse_norm;  ///< 1/|(s, t, 1)| at those texels' centres
};

/// Integral of dw over a face from its middle to the point (s, t) in [-1, 1]^2: atan(s t / sqrt(1 + s^2 + t^2)), sr.
double solidAngleTo(double s, double t);

/// Mips of a cube, evaluated at the centres of its texels. Immutable.
class CubePyramid {
 public:
  /// `size` is a power of two in [2, 4096]. Parallel over rows; the same bits for any number of threads.
  CubePyramid(int size, const Radiance& radiance);

  /// Mips from the largest to one of two texels.
  const std::vector<CubeLevel>& levels() const { return levels_; }

 private:
  std::vector<CubeLevel> levels_;
};

}  // namespace welkin::reflection
