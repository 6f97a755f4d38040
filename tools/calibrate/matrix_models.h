// SPDX-License-Identifier: Apache-2.0
// Models that are linear in their numbers and that keep to exposure: light k times as strong gives k times the result.
#pragma once

#include "calibrate/model.h"

namespace welkin::calibrate {

/// What a matrix multiplies, without memory of its own.
using TermVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;

/// A 3x3 matrix of linear Rec. 709, by least squares; its nine numbers row by row.
inline constexpr std::size_t kMatrixNumbers = 9;
std::optional<std::vector<double>> fitMatrix(std::span<const Pair> pairs);
Colour applyMatrix(std::span<const double> numbers, const Colour& measured);

/// A 3x6 matrix of r, g, b, sqrt(r g), sqrt(g b) and sqrt(r b) (G. D. Finlayson, M. Mackiewicz and A. Hurlbert, "Color
/// correction using root-polynomial regression", IEEE Transactions on Image Processing 24, 2015, degree 2). Channels
/// below 0 count as 0 under the roots.
inline constexpr std::size_t kRootPolynomialNumbers = 18;
TermVector rootTerms(const Colour& c);
std::optional<std::vector<double>> fitRootPolynomial(std::span<const Pair> pairs);
Colour applyRootPolynomial(std::span<const double> numbers, const Colour& measured);

}  // namespace welkin::calibrate
