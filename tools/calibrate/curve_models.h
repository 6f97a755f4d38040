// SPDX-License-Identifier: Apache-2.0
// Models with a curve for all channels before what is linear, fitted to perceived differences.
#pragma once

#include "calibrate/model.h"

namespace welkin::calibrate {

/// The brightest channel of the chart, v = 1; two numbers of the curve; a 3x4 matrix, row by row, whose last column is
/// added to v = 1. The curve is u = v^exp(q), then e^t u / (1 + (e^t - 1) u): a power and a shoulder or toe. It rises
/// for all q and t, and past v = 1 it goes on along its tangent.
inline constexpr std::size_t kCurveAffineNumbers = 3 + 12;
std::optional<std::vector<double>> fitCurveAffine(std::span<const Pair> pairs);
Colour applyCurveAffine(std::span<const double> numbers, const Colour& measured);

/// The same with a 3x6 matrix of the terms of the root polynomial.
inline constexpr std::size_t kCurveRootNumbers = 3 + 18;
std::optional<std::vector<double>> fitCurveRoot(std::span<const Pair> pairs);
Colour applyCurveRoot(std::span<const double> numbers, const Colour& measured);

}  // namespace welkin::calibrate
