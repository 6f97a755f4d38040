// SPDX-License-Identifier: Apache-2.0
// The points that prove how good an approximation can be, and their exchange: what Minimax is made of.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "sh/small_solve.h"

namespace welkin::sh {

/// Index of the value that is largest in magnitude, the first of equals; `value` is not empty.
std::size_t largest(std::span<const double> value);

/// rank + 1 points and the signs of their errors, such that no coefficients make all of these errors smaller than they
/// are when they have equal size: the multipliers sign[i] times a number >= 0 make the basis 0 and their sizes add up
/// to 1.
class Reference {
 public:
  /// `columns`: orthonormal, one after the other, with `wanted` behind them.
  Reference(std::span<const double> columns, std::size_t points) : columns_(columns), points_(points) {}

  /// Takes points on which the columns are independent, by elimination of the rows times `preference`, the largest
  /// entry first; the last one where the target is worst interpolated by the others. Whether there are such points.
  bool start(std::span<const double> preference);

  /// Finds coefficients, level and multipliers. Whether the points allow it.
  bool solve();

  /// Takes in point `at`, whose error has `sign`, for the one that must go so that the multipliers keep their signs; of
  /// several, for that on which it depends most.
  void exchange(std::size_t at, double sign);

  /// Of the columns: errors of equal size on the points.
  const SmallVector& coefficient() const { return coefficient_; }
  /// What every coefficients' worst error on these points is not below.
  double bound() const { return bound_; }

 private:
  std::size_t rank() const { return columns_.size() / points_ - 1; }
  double entry(std::size_t point, std::size_t column) const { return columns_[column * points_ + point]; }

  std::span<const double> columns_;
  std::size_t points_;
  std::array<std::size_t, kMostEquations> point_{};
  SmallVector sign_{};
  SmallVector coefficient_{};
  SmallVector multiplier_{};
  double bound_ = 0.0;
  Factors factors_;
};

}  // namespace welkin::sh
