// SPDX-License-Identifier: Apache-2.0
// Minimax approximation at discrete points: the combination of a few basis functions whose largest weighted error is
// least. Only + - * / and sqrt in fixed order: the same bits on every machine.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sh/small_solve.h"

namespace welkin::sh {

inline constexpr std::size_t kMostMinimaxColumns = kMostEquations - 1;

/// When to stop: the error is within 1 + `excess` of what is proven to be out of reach, or after `steps` exchanges.
struct MinimaxLimits {
  double excess = 0.01;
  std::size_t steps = 200;
};

/// Coefficients and what they are worth.
struct MinimaxFit {
  std::vector<double> coefficient;   ///< one a column; 0 for a column that others make up
  double error = 0.0;                ///< largest weight |target - basis coefficient|; not above least_squares_error
  double lower_bound = 0.0;          ///< no coefficients do better than this; up to rounding; not above `error`
  double least_squares_error = 0.0;  ///< the largest one of the weighted least squares fit, where it starts
  std::size_t steps = 0;             ///< exchanges made
};

/// Fits targets by the same basis at the same points.
class Minimax {
 public:
  /// `basis`: points x columns, row-major, each 0 or of 1e-100 to 1e100; 1 to kMostMinimaxColumns columns. `weight`:
  /// one a point, not negative, or none: all 1. Columns may depend on each other: one of which less than 1e-10 of its
  /// length is independent of the others is left out, and bounds are those of the rest.
  Minimax(std::span<const double> basis, std::size_t columns, std::span<const double> weight = {});

  /// The exchange algorithm for any basis, with the point of the largest error exchanged (Stiefel, "Ueber diskrete und
  /// lineare Tschebyscheff-Approximationen", 1959; as the simplex method on the dual linear program: Barrodale and
  /// Phillips, "Algorithm 495", 1975): rank + 1 points on which the least error is known prove a lower bound that
  /// grows until the error elsewhere meets it. It may stand still where points fall together; when the steps run out,
  /// the best so far is returned with the bound that it has.
  MinimaxFit fit(std::span<const double> target, const MinimaxLimits& limits = {}) const;

 private:
  std::span<const double> column(const std::vector<double>& of, std::size_t k) const {
    return std::span(of).subspan(k * points_, points_);
  }
  std::vector<double> columnCoefficients(std::span<const double> orthonormal) const;
  double errorOf(std::span<const double> coefficient, std::span<const double> weighted_target) const;

  std::size_t points_ = 0;
  std::size_t columns_ = 0;
  std::vector<double> weight_;
  std::vector<double> weighted_;        ///< the basis times the weights, by column
  std::vector<double> orthonormal_;     ///< the same span, by column: weighted_ of pivot_[k] = sum_j r_[j][k] of these
  std::vector<std::size_t> pivot_;      ///< the columns that are used; as many as the rank
  std::vector<std::vector<double>> r_;  ///< upper triangle, row j
};

}  // namespace welkin::sh
