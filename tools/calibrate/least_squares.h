// SPDX-License-Identifier: Apache-2.0
// Weighted linear least squares in double, which tells when the data do not determine the unknowns.
#pragma once

#include <Eigen/Core>
#include <optional>

namespace welkin::calibrate {

/// The X of least |diag(sqrt(weight)) (rows X - wanted)|, by a QR decomposition with pivots of columns scaled to length
/// 1. None if a pivot is below `smallest_pivot` of the largest, so that the unknowns are not determined.
std::optional<Eigen::MatrixXd> leastSquares(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& wanted,
                                            const Eigen::VectorXd& weight, double smallest_pivot = 1e-6);

}  // namespace welkin::calibrate
