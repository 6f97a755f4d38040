// SPDX-License-Identifier: Apache-2.0
// Nonlinear least squares for a few unknowns.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace welkin::calibrate {

/// Near the square root of the rounding, where one-sided differences of exact functions are best.
inline constexpr double kSmallStep = 1e-7;

/// Improves `unknowns` until the sum of squares of `residuals` falls by less than 1e-5 of itself a step, or for at
/// most 30 steps (K. Levenberg 1944, D. W. Marquardt 1963; derivatives by one-sided differences over `step` times the
/// unknown or 1). The sum never rises.
Eigen::VectorXd leastSquaresFrom(Eigen::VectorXd unknowns,
                                 const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& residuals,
                                 double step = kSmallStep);

}  // namespace welkin::calibrate
