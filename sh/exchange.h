// SPDX-License-Identifier: Apache-2.0
// Exchange of the points that prove how good an approximation can be. A part of Minimax; nothing else includes it.
#pragma once

#include <Eigen/LU>
#include <vector>

#include "sh/matrix.h"
#include "sh/minimax.h"

namespace welkin::sh {

/// Index of the value of largest magnitude, the first one of equal values. `value` is not empty.
Eigen::Index largest(const Eigen::VectorXd& value);

/// rank + 1 points and the signs of the errors there. The multipliers sign[i] times a number >= 0 combine these rows of
/// the basis to 0, and their sizes add up to 1. Therefore no coefficients make all of these errors smaller than they
/// are when they have equal size.
class Reference {
 public:
  /// `orthonormal`: the basis by column, at most kMostMinimaxColumns of them. Both arguments must outlive this object.
  Reference(const Eigen::MatrixXd& orthonormal, const Eigen::VectorXd& wanted);

  /// Chooses points where the columns are independent. Eliminates the rows times `preference`, with the largest entry
  /// of each column as pivot. The last point is the one where the other points interpolate the target worst. Returns
  /// false if there are no such points.
  bool start(const Eigen::VectorXd& preference);

  /// Finds coefficients, bound and multipliers. Returns false if the equations are singular.
  bool solve();

  /// Replaces one point by point `at`, whose error has the sign `sign`, so that the multipliers keep their signs. If
  /// several points could go, the one whose multiplier changes fastest goes.
  void exchange(Eigen::Index at, double sign);

  /// Coefficients of the columns that give errors of equal size on the points.
  const Eigen::VectorXd& coefficient() const { return coefficient_; }
  /// A lower bound of the largest error on these points, for any coefficients.
  double bound() const { return bound_; }

 private:
  static constexpr int kMost = static_cast<int>(kMostMinimaxColumns) + 1;
  using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMost, 1>;
  using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMost, kMost>;

  const Eigen::MatrixXd& orthonormal_;
  const Eigen::VectorXd& wanted_;
  std::vector<Eigen::Index> point_;
  SmallVector sign_;
  SmallVector multiplier_;
  Eigen::VectorXd coefficient_;
  double bound_ = 0.0;
  Eigen::PartialPivLU<SmallMatrix> equations_;
};

}  // namespace welkin::sh
