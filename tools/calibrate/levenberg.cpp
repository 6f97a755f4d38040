// SPDX-License-Identifier: Apache-2.0
#include "calibrate/levenberg.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace welkin::calibrate {
namespace {

using Residuals = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

Eigen::MatrixXd derivatives(const Eigen::VectorXd& x, const Eigen::VectorXd& at_x, const Residuals& residuals,
                            double step) {
  Eigen::MatrixXd result(at_x.size(), x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    Eigen::VectorXd up = x;
    up[i] += step * std::max(1.0, std::abs(x[i]));
    result.col(i) = (residuals(up) - at_x) / (up[i] - x[i]);
  }
  return result;
}

}  // namespace

Eigen::VectorXd leastSquaresFrom(Eigen::VectorXd unknowns, const Residuals& residuals, double step) {
  constexpr int kMostSteps = 30;
  constexpr double kEnough = 1e-5, kMostDamping = 1e8;
  double damping = 1e-3;
  Eigen::VectorXd left = residuals(unknowns);
  for (int i = 0; i < kMostSteps && damping <= kMostDamping; ++i) {
    const Eigen::MatrixXd slope = derivatives(unknowns, left, residuals, step);
    Eigen::MatrixXd normal = slope.transpose() * slope;
    const Eigen::VectorXd gradient = slope.transpose() * left;
    const Eigen::VectorXd diagonal = normal.diagonal().cwiseMax(1e-12);
    bool better = false;
    for (; !better && damping <= kMostDamping; damping *= better ? 0.2 : 4.0) {
      Eigen::MatrixXd damped = normal;
      damped.diagonal() += damping * diagonal;
      const Eigen::VectorXd next = unknowns - damped.ldlt().solve(gradient);
      const Eigen::VectorXd next_left = residuals(next);
      better = next_left.allFinite() && next_left.squaredNorm() < left.squaredNorm();
      if (!better) continue;
      const bool enough = left.squaredNorm() - next_left.squaredNorm() < kEnough * left.squaredNorm();
      unknowns = next;
      left = next_left;
      if (enough) return unknowns;
    }
  }
  return unknowns;
}

}  // namespace welkin::calibrate
