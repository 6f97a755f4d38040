// SPDX-License-Identifier: Apache-2.0
// Square systems of up to 17 linear equations, with the same bits on every machine.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace welkin::sh {

inline constexpr std::size_t kMostEquations = 17;
using SmallVector = std::array<double, kMostEquations>;
using SmallMatrix = std::array<SmallVector, kMostEquations>;

/// A matrix as triangular factors, by elimination with row pivots.
class Factors {
 public:
  /// Whether the first n x n of `matrix` are not singular.
  bool eliminate(const SmallMatrix& matrix, std::size_t n) {
    n_ = n;
    factor_ = matrix;
    for (std::size_t i = 0; i < n; ++i) row_[i] = i;
    for (std::size_t k = 0; k < n; ++k) {
      std::size_t pivot = k;
      for (std::size_t i = k + 1; i < n; ++i)
        if (std::abs(factor_[i][k]) > std::abs(factor_[pivot][k])) pivot = i;
      std::swap(factor_[k], factor_[pivot]);
      std::swap(row_[k], row_[pivot]);
      if (factor_[k][k] == 0.0) return false;
      for (std::size_t i = k + 1; i < n; ++i) {
        const double factor = factor_[i][k] / factor_[k][k];
        factor_[i][k] = factor;
        for (std::size_t j = k + 1; j < n; ++j) factor_[i][j] -= factor * factor_[k][j];
      }
    }
    return true;
  }

  /// x of matrix x = b.
  SmallVector solve(const SmallVector& b) const {
    SmallVector x{};
    for (std::size_t i = 0; i < n_; ++i) {
      x[i] = b[row_[i]];
      for (std::size_t j = 0; j < i; ++j) x[i] -= factor_[i][j] * x[j];
    }
    for (std::size_t i = n_; i-- > 0;) {
      for (std::size_t j = i + 1; j < n_; ++j) x[i] -= factor_[i][j] * x[j];
      x[i] /= factor_[i][i];
    }
    return x;
  }

  /// x of transpose(matrix) x = b.
  SmallVector solveTransposed(SmallVector b) const {
    for (std::size_t i = 0; i < n_; ++i) {
      b[i] /= factor_[i][i];
      for (std::size_t j = i + 1; j < n_; ++j) b[j] -= factor_[i][j] * b[i];
    }
    for (std::size_t i = n_; i-- > 0;)
      for (std::size_t j = 0; j < i; ++j) b[j] -= factor_[i][j] * b[i];
    SmallVector x{};
    for (std::size_t i = 0; i < n_; ++i) x[row_[i]] = b[i];
    return x;
  }

 private:
  std::size_t n_ = 0;
  SmallMatrix factor_{};
  std::array<std::size_t, kMostEquations> row_{};
};

}  // namespace welkin::sh
