// SPDX-License-Identifier: Apache-2.0
#include "sh/exchange.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace welkin::sh {
namespace {

template <typename Matrix>
bool isSingular(const Eigen::PartialPivLU<Matrix>& factors) {
  return (factors.matrixLU().diagonal().array() == 0.0).any();
}

}  // namespace

Eigen::Index largest(const Eigen::VectorXd& value) {
  Eigen::Index at = 0;
  value.cwiseAbs().maxCoeff(&at);
  return at;
}

Reference::Reference(const Eigen::MatrixXd& orthonormal, const Eigen::VectorXd& wanted)
    : orthonormal_(orthonormal),
      wanted_(wanted),
      point_(static_cast<std::size_t>(orthonormal.cols()) + 1),
      sign_(orthonormal.cols() + 1) {}

bool Reference::start(const Eigen::VectorXd& preference) {
  const Eigen::Index rank = orthonormal_.cols();
  Eigen::MatrixXd left(orthonormal_.rows(), rank + 1);
  left << orthonormal_, wanted_;
  left.array().colwise() *= preference.array();
  for (Eigen::Index k = 0; k <= rank; ++k) {
    Eigen::Index& point = point_[static_cast<std::size_t>(k)];
    left.col(k).cwiseAbs().maxCoeff(&point);
    if (left(point, k) == 0.0) return false;
    const SmallVector factor = left.row(point).tail(rank - k).transpose() / left(point, k);
    left.rightCols(rank - k).noalias() -= left.col(k) * factor.transpose();
  }
  const SmallMatrix rows = orthonormal_(point_, Eigen::all).transpose();
  const Eigen::PartialPivLU<SmallMatrix> interpolation(rows.leftCols(rank));
  if (isSingular(interpolation)) return false;
  SmallVector multiplier(rank + 1);
  multiplier << -interpolation.solve(rows.col(rank)), 1.0;
  const double level = multiplier.dot(wanted_(point_));
  for (Eigen::Index i = 0; i <= rank; ++i) sign_[i] = (multiplier[i] < 0.0) == (level < 0.0) ? 1.0 : -1.0;
  return true;
}

bool Reference::solve() {
  const Eigen::Index rank = orthonormal_.cols();
  SmallMatrix matrix(rank + 1, rank + 1);
  matrix << orthonormal_(point_, Eigen::all), sign_;
  equations_.compute(matrix);
  if (isSingular(equations_)) return false;
  const SmallVector wanted = wanted_(point_);
  coefficient_ = equations_.solve(wanted).head(rank);
  multiplier_ = equations_.transpose().solve(SmallVector::Unit(rank + 1, rank));
  bound_ = std::abs(multiplier_.dot(wanted)) / multiplier_.lpNorm<1>();
  return true;
}

void Reference::exchange(Eigen::Index at, double sign) {
  constexpr double kNone = 1e-12;  // counts as 0, for a multiplier (they add up to 1) and relative to the largest fall
  const Eigen::Index rank = orthonormal_.cols();
  SmallVector entering(rank + 1);
  entering << orthonormal_.row(at).transpose(), sign;
  SmallVector falls = equations_.transpose().solve(entering);
  falls = sign * falls.cwiseProduct(sign_);
  const double most = std::max(falls.maxCoeff(), 0.0);
  Eigen::Index leaving = 0;
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i <= rank; ++i) {
    if (falls[i] <= kNone * most) continue;
    const double multiplier = sign_[i] * multiplier_[i];
    const double ratio = multiplier <= kNone ? 0.0 : multiplier / falls[i];
    if (ratio < least || (ratio == least && falls[i] > falls[leaving])) {
      least = ratio;
      leaving = i;
    }
  }
  point_[static_cast<std::size_t>(leaving)] = at;
  sign_[leaving] = sign;
}

}  // namespace welkin::sh
