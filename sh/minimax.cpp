// SPDX-License-Identifier: Apache-2.0
#include "sh/minimax.h"

#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "sh/exchange.h"
#include "sh/matrix.h"

namespace welkin::sh {

/// The weighted columns, and orthonormal ones that span the same space.
struct Minimax::Basis {
  Eigen::VectorXd weight;
  Eigen::MatrixXd weighted;
  Eigen::VectorXd length;                            ///< of each weighted column; 1 for a column of zeros
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> unit;  ///< the columns over their lengths, factored
  Eigen::MatrixXd orthonormal;

  /// Converts coefficients of the orthonormal columns to coefficients of the original columns.
  Eigen::VectorXd columnCoefficients(const Eigen::VectorXd& at) const {
    const Eigen::Index rank = orthonormal.cols();
    Eigen::VectorXd coefficient = Eigen::VectorXd::Zero(weighted.cols());
    coefficient.head(rank) = unit.matrixR().topLeftCorner(rank, rank).triangularView<Eigen::Upper>().solve(at);
    return (unit.colsPermutation() * coefficient).cwiseQuotient(length);
  }

  double errorOf(const Eigen::VectorXd& coefficient, const Eigen::VectorXd& wanted) const {
    return (wanted - weighted * coefficient).lpNorm<Eigen::Infinity>();
  }
};

Minimax::Minimax(std::span<const double> basis, std::size_t columns, std::span<const double> weight) {
  constexpr double kIndependent = 1e-10;  // relative length of the part of a column outside the others' span
  assert(columns >= 1 && columns <= kMostMinimaxColumns && basis.size() % columns == 0);
  assert(weight.empty() || weight.size() == basis.size() / columns);
  const auto rows = asRows(basis, columns);
  auto made = std::make_shared<Basis>();
  made->weight = weight.empty() ? Eigen::VectorXd::Ones(rows.rows()).eval() : asVector(weight);
  made->weighted = made->weight.asDiagonal() * rows;
  made->length = made->weighted.colwise().norm();
  for (double& length : made->length)
    if (length == 0.0) length = 1.0;
  made->unit.compute(made->weighted * made->length.cwiseInverse().asDiagonal());
  made->unit.setThreshold(kIndependent);
  made->orthonormal = Eigen::MatrixXd::Identity(rows.rows(), made->unit.rank());
  if (made->unit.rank() > 0) made->orthonormal.applyOnTheLeft(made->unit.householderQ());
  basis_ = std::move(made);
}

MinimaxFit Minimax::fit(std::span<const double> target, const MinimaxLimits& limits) const {
  constexpr double kPreferred = 1e-3;  // above 0: points without error are needed where the others are not independent
  constexpr double kRounding = 1e-14;  // relative to the target: smaller differences are rounding
  const Eigen::MatrixXd& orthonormal = basis_->orthonormal;
  const auto points = static_cast<std::size_t>(orthonormal.rows());
  assert(target.size() == points);
  const Eigen::VectorXd wanted = basis_->weight.cwiseProduct(asVector(target));
  Eigen::VectorXd best = orthonormal.transpose() * wanted;
  Eigen::VectorXd error = wanted - orthonormal * best;
  Eigen::VectorXd coefficient = basis_->columnCoefficients(best);
  MinimaxFit result;
  const auto finish = [&] {
    result.coefficient.assign(coefficient.begin(), coefficient.end());
    return result;
  };
  result.least_squares_error = result.error = basis_->errorOf(coefficient, wanted);
  const double rounding = kRounding * wanted.lpNorm<Eigen::Infinity>();
  if (points <= static_cast<std::size_t>(orthonormal.cols()) || result.error <= rounding) return finish();

  // The extrema of this fit are near those of the best one.
  const double least_preferred = kPreferred * error.lpNorm<Eigen::Infinity>();
  Reference reference(orthonormal, wanted);
  if (!reference.start(error.cwiseAbs().cwiseMax(least_preferred))) return finish();
  double least = result.error;
  while (reference.solve()) {
    result.lower_bound = std::max(result.lower_bound, reference.bound());
    error = wanted;
    error.noalias() -= orthonormal * reference.coefficient();
    const Eigen::Index next = largest(error);
    if (std::abs(error[next]) < least) {
      least = std::abs(error[next]);
      best = reference.coefficient();
    }
    if (least <= (1.0 + limits.excess) * result.lower_bound + rounding || result.steps == limits.steps) break;
    reference.exchange(next, error[next] < 0.0 ? -1.0 : 1.0);
    ++result.steps;
  }
  const Eigen::VectorXd refined = basis_->columnCoefficients(best);
  least = basis_->errorOf(refined, wanted);
  if (least < result.error) {
    result.error = least;
    coefficient = refined;
  }
  result.lower_bound = std::min(result.lower_bound, result.error);
  return finish();
}

}  // namespace welkin::sh
