// SPDX-License-Identifier: Apache-2.0
// Rotation of spherical harmonic coefficients.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "sh/deterministic.h"

namespace welkin::sh {

/// Rows of an orthogonal matrix. Row i gives component i of the direction that it is applied to.
using Matrix3 = std::array<det::Number3, 3>;

/// Axes of a frame whose pole is +y: its (x, y, z) are the world's (z, x, y).
inline constexpr Matrix3 kPolarAxes = {det::Number3(0, 0, 1), det::Number3(1, 0, 0), det::Number3(0, 1, 0)};

det::Number3 apply(const Matrix3& matrix, const det::Number3& v);

/// Turns the coefficients of f into those of g(d) = f(apply(matrix, d)), for any orthogonal matrix. Band l uses its own
/// block of (2 l + 1)^2 numbers. A product quadrature, exact for products of two basis functions of a band, computes
/// it.
class Rotation {
 public:
  Rotation(int bands, const Matrix3& matrix);
  /// `in` and `out` hold bands^2 numbers and do not overlap.
  void apply(std::span<const double> in, std::span<double> out) const;

 private:
  int bands_;
  std::vector<std::vector<double>> block_;  ///< per band, row-major
};

/// The matrix whose Rotation turns a sky by `angle_rad` about +y, clockwise seen from above (growing azimuth).
Matrix3 azimuthRotation(double angle_rad);

}  // namespace welkin::sh
