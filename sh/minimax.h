// SPDX-License-Identifier: Apache-2.0
// Minimax approximation at discrete points: the combination of a few basis functions whose largest weighted error is
// smallest. The same bits on every machine, as sh/matrix.h uses Eigen.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace welkin::sh {

inline constexpr std::size_t kMostMinimaxColumns = 16;

/// Limits of the iteration: it stops when the error is at most 1 + `excess` times the proven lower bound, or after
/// `steps` exchanges.
struct MinimaxLimits {
  double excess = 0.01;
  std::size_t steps = 200;
};

/// Coefficients and their error.
struct MinimaxFit {
  std::vector<double> coefficient;   ///< one per column; 0 for a column that depends on the others
  double error = 0.0;                ///< largest weight |target - basis coefficient|; at most least_squares_error
  double lower_bound = 0.0;          ///< no coefficients have a smaller error, up to rounding; at most `error`
  double least_squares_error = 0.0;  ///< largest error of the weighted least squares fit, where the iteration starts
  std::size_t steps = 0;             ///< exchanges made
};

/// Fits targets by the same basis at the same points.
class Minimax {
 public:
  /// `basis`: points x columns, row-major, each entry 0 or of 1e-100 to 1e100; 1 to kMostMinimaxColumns columns.
  /// `weight`: one per point, not negative; empty: all 1. Columns may depend on each other. A column is left out if
  /// less than 1e-10 of its length lies outside the span of the others. The bounds then hold for the other columns.
  Minimax(std::span<const double> basis, std::size_t columns, std::span<const double> weight = {});

  /// The exchange algorithm for any basis, with the point of the largest error exchanged (Stiefel, "Ueber diskrete und
  /// lineare Tschebyscheff-Approximationen", 1959; as the simplex method on the dual linear program: Barrodale and
  /// Phillips, "Algorithm 495", 1975). The least error on rank + 1 points is known and is a lower bound; it grows until
  /// the error at all other points meets it. The iteration can stall where points coincide. When the steps run out,
  /// the best fit so far is returned with its bound.
  MinimaxFit fit(std::span<const double> target, const MinimaxLimits& limits = {}) const;

 private:
  struct Basis;
  std::shared_ptr<const Basis> basis_;
};

}  // namespace welkin::sh
