// SPDX-License-Identifier: Apache-2.0
#include "calibrate/least_squares.h"

#include <Eigen/QR>

namespace welkin::calibrate {

std::optional<Eigen::MatrixXd> leastSquares(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& wanted,
                                            const Eigen::VectorXd& weight, double smallest_pivot) {
  if (rows.rows() < rows.cols()) return std::nullopt;
  const Eigen::VectorXd root = weight.cwiseSqrt();
  Eigen::MatrixXd a = root.asDiagonal() * rows;
  const Eigen::VectorXd length = a.colwise().norm();
  if (!(length.minCoeff() > 0.0) || !length.allFinite()) return std::nullopt;
  a = a * length.cwiseInverse().asDiagonal();
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
  qr.setThreshold(smallest_pivot);
  qr.compute(a);
  if (qr.rank() < a.cols()) return std::nullopt;
  const Eigen::MatrixXd scaled = qr.solve(root.asDiagonal() * wanted);
  return length.cwiseInverse().asDiagonal() * scaled;
}

}  // namespace welkin::calibrate
