// SPDX-License-Identifier: Apache-2.0
#include "sh/modes.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "sh/matrix.h"

namespace welkin::sh {
namespace {

/// An orthonormal basis (columns) of the snapshots' span, and each snapshot's coordinates in it (one column each).
struct Span {
  Eigen::MatrixXd basis;
  Eigen::MatrixXd coordinates;
};

/// QR of the snapshots, each divided by its length: a pivot is then the relative length outside the span so far.
Span spanOf(const Snapshots& snapshots) {
  constexpr double kInside = 1e-10;  // relative length of a part that counts as rounding
  if (snapshots.count() == 0) return {};
  const Eigen::MatrixXd columns = asRows(snapshots.value, snapshots.dimension).transpose();
  const Eigen::RowVectorXd length = columns.colwise().norm();
  const auto scale = (length.array() > 0.0).select(length, 1.0);
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns.array().rowwise() / scale.array());
  qr.setThreshold(kInside);
  const Eigen::Index rank = qr.rank();
  if (rank == 0) return {};
  Span span;
  span.basis = Eigen::MatrixXd::Identity(columns.rows(), rank);
  span.basis.applyOnTheLeft(qr.householderQ());
  span.coordinates = qr.matrixR().topRows(rank).triangularView<Eigen::Upper>();
  span.coordinates = span.coordinates * qr.colsPermutation().transpose() * length.asDiagonal();
  return span;
}

/// The shares, scaled so that they add up to 1.
Eigen::VectorXd normalised(const Eigen::VectorXd& share) {
  const Eigen::VectorXd relative = share / share.maxCoeff();  // so that the sum is finite
  return relative / relative.sum();
}

/// The weights, or equal ones if there are none, scaled so that they add up to 1.
Eigen::VectorXd sharesOf(std::span<const double> weights, std::size_t count) {
  assert(weights.empty() || weights.size() == count);
  if (count == 0) return {};
  if (weights.empty()) return normalised(Eigen::VectorXd::Ones(static_cast<Eigen::Index>(count)));
  return normalised(asVector(weights));
}

/// The leading eigenvectors of the snapshots' weighted Gram matrix in the coordinates of their span.
Modes modesIn(const Span& span, std::size_t dimension, const Eigen::VectorXd& share, std::size_t count) {
  Modes modes;
  modes.dimension = dimension;
  const Eigen::Index rank = span.basis.cols();
  if (rank == 0) return modes;
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(rank, rank);
  gram.selfadjointView<Eigen::Lower>().rankUpdate(span.coordinates * share.cwiseSqrt().asDiagonal());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(gram);  // ascending
  const Eigen::Index kept = std::min(static_cast<Eigen::Index>(count), rank);
  Eigen::MatrixXd vector = span.basis * eigen.eigenvectors().rightCols(kept).rowwise().reverse();
  for (auto mode : vector.colwise()) {
    Eigen::Index largest = 0;
    mode.cwiseAbs().maxCoeff(&largest);
    if (mode[largest] < 0.0) mode = -mode;
  }
  modes.vector.assign(vector.data(), vector.data() + vector.size());
  for (Eigen::Index k = 0; k < kept; ++k) modes.energy.push_back(std::max(eigen.eigenvalues()[rank - 1 - k], 0.0));
  return modes;
}

}  // namespace

Modes leadingModes(const Snapshots& snapshots, std::span<const double> weights, std::size_t count) {
  return modesIn(spanOf(snapshots), snapshots.dimension, sharesOf(weights, snapshots.count()), count);
}

void projectOntoModes(const Modes& modes, std::span<const double> snapshot, std::span<double> coefficients,
                      std::span<double> residual) {
  const auto rows = asRows(modes.vector, modes.dimension);
  auto along = asVector(coefficients);
  auto rest = asVector(residual);
  along.noalias() = rows * asVector(snapshot);
  rest = asVector(snapshot);
  rest.noalias() -= rows.transpose() * along;
}

double MaximumNorm::operator()(std::size_t i, std::span<const double> residual) const {
  const double largest = map.empty() ? asVector(residual).lpNorm<Eigen::Infinity>()
                                     : (asRows(map, residual.size()) * asVector(residual)).lpNorm<Eigen::Infinity>();
  return scale.empty() ? largest : largest / scale[i];
}

RefinedModes refineModes(const Snapshots& snapshots, std::span<const double> weights, std::size_t count,
                         const ErrorMeasure& measure, std::size_t steps) {
  constexpr double kKept = 0.1;  // keeps the weight of an exact snapshot above 0; values of 0 to 0.1 do equally well
  const Span span = spanOf(snapshots);
  Eigen::VectorXd share = sharesOf(weights, snapshots.count());
  std::vector<double> error(snapshots.count());
  std::vector<double> residual(snapshots.dimension);
  RefinedModes best;
  for (std::size_t step = 0; step <= steps; ++step) {
    Modes modes = modesIn(span, snapshots.dimension, share, count);
    std::vector<double> coefficients(modes.count());
    for (std::size_t i = 0; i < error.size(); ++i) {
      projectOntoModes(modes, snapshots.row(i), coefficients, residual);
      error[i] = measure(i, residual);
    }
    const auto worst = std::max_element(error.begin(), error.end());
    if (worst == error.end()) return best;
    if (step == 0) best.start_error = *worst;
    if (step == 0 || *worst < best.error) {
      best.modes = std::move(modes);
      best.error = *worst;
      best.worst = static_cast<std::size_t>(worst - error.begin());
      best.step = step;
    }
    if (*worst == 0.0) break;
    share = normalised(share.array() * (kKept + asVector(error).array() / *worst));
  }
  return best;
}

}  // namespace welkin::sh
