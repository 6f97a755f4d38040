// SPDX-License-Identifier: Apache-2.0
#include "sh/minimax.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sh/dot.h"
#include "sh/exchange.h"

namespace welkin::sh {

Minimax::Minimax(std::span<const double> basis, std::size_t columns, std::span<const double> weight)
    : points_(basis.size() / columns),
      columns_(columns),
      weight_(weight.begin(), weight.end()),
      weighted_(basis.size()),
      r_(columns, std::vector<double>(columns, 0.0)) {
  constexpr double kIndependent = 1e-20;  // square of the relative length that makes a column independent
  assert(columns >= 1 && columns <= kMostMinimaxColumns && basis.size() == points_ * columns);
  assert(weight.empty() || weight.size() == points_);
  if (weight_.empty()) weight_.assign(points_, 1.0);
  for (std::size_t k = 0; k < columns; ++k)
    for (std::size_t i = 0; i < points_; ++i) weighted_[k * points_ + i] = weight_[i] * basis[i * columns + k];

  // Gram and Schmidt's method, the column next of which the largest part is left.
  std::vector<double> left = weighted_;
  const auto rest = [&](std::size_t k) { return std::span(left).subspan(k * points_, points_); };
  std::vector<double> square(columns);
  std::vector<bool> used(columns, false);
  std::vector<std::vector<double>> along(columns, std::vector<double>(columns, 0.0));  // of column k, along j
  for (std::size_t k = 0; k < columns; ++k) square[k] = dot(rest(k), rest(k));
  while (pivot_.size() < columns) {
    std::size_t next = columns;
    double most = kIndependent;
    for (std::size_t k = 0; k < columns; ++k) {
      if (used[k] || square[k] == 0.0) continue;
      const double share = dot(rest(k), rest(k)) / square[k];
      if (share > most) {
        most = share;
        next = k;
      }
    }
    if (next == columns) break;
    const auto v = rest(next);
    const std::size_t rank = pivot_.size();
    for (std::size_t j = 0; j < rank; ++j) {  // what rounding has left along the others
      const double again = dot(column(orthonormal_, j), v);
      along[next][j] += again;
      addMultiple(-again, column(orthonormal_, j), v);
    }
    const double length = std::sqrt(dot(v, v));
    along[next][rank] = length;
    for (const double x : v) orthonormal_.push_back(x / length);
    used[next] = true;
    pivot_.push_back(next);
    for (std::size_t k = 0; k < columns; ++k) {
      if (used[k]) continue;
      along[k][rank] = dot(column(orthonormal_, rank), rest(k));
      addMultiple(-along[k][rank], column(orthonormal_, rank), rest(k));
    }
  }
  for (std::size_t k = 0; k < pivot_.size(); ++k)
    for (std::size_t j = 0; j <= k; ++j) r_[j][k] = along[pivot_[k]][j];
}

std::vector<double> Minimax::columnCoefficients(std::span<const double> orthonormal) const {
  std::vector<double> coefficient(columns_, 0.0);
  for (std::size_t k = pivot_.size(); k-- > 0;) {
    double sum = orthonormal[k];
    for (std::size_t j = k + 1; j < pivot_.size(); ++j) sum -= r_[k][j] * coefficient[pivot_[j]];
    coefficient[pivot_[k]] = sum / r_[k][k];
  }
  return coefficient;
}

double Minimax::errorOf(std::span<const double> coefficient, std::span<const double> weighted_target) const {
  std::vector<double> error(weighted_target.begin(), weighted_target.end());
  for (std::size_t k = 0; k < columns_; ++k) addMultiple(-coefficient[k], column(weighted_, k), error);
  return error.empty() ? 0.0 : std::abs(error[largest(error)]);
}

MinimaxFit Minimax::fit(std::span<const double> target, const MinimaxLimits& limits) const {
  constexpr double kPreferred = 1e-3;  // points without error may be needed too, where others are no independent ones
  constexpr double kRounding = 1e-14;  // of the target: a difference that is none
  assert(target.size() == points_);
  const std::size_t rank = pivot_.size();
  std::vector<double> wanted(points_);
  for (std::size_t i = 0; i < points_; ++i) wanted[i] = weight_[i] * target[i];

  std::vector<double> error = wanted;
  SmallVector at{};
  for (std::size_t k = 0; k < rank; ++k) {
    at[k] = dot(column(orthonormal_, k), error);
    addMultiple(-at[k], column(orthonormal_, k), error);
  }
  MinimaxFit result;
  result.coefficient = columnCoefficients(at);
  result.least_squares_error = result.error = errorOf(result.coefficient, wanted);
  if (points_ == 0) return result;
  const double rounding = kRounding * std::abs(wanted[largest(wanted)]);
  if (points_ <= rank || result.error <= rounding) return result;

  std::vector<double> columns = orthonormal_;
  columns.insert(columns.end(), wanted.begin(), wanted.end());
  Reference reference(columns, points_);
  const double least_preferred = kPreferred * std::abs(error[largest(error)]);
  for (double& e : error) e = std::max(std::abs(e), least_preferred);  // extrema of this fit are near those of the best
  if (!reference.start(error)) return result;
  SmallVector best = at;
  double least = result.error;
  while (reference.solve()) {
    result.lower_bound = std::max(result.lower_bound, reference.bound());
    error = wanted;
    for (std::size_t k = 0; k < rank; ++k) addMultiple(-reference.coefficient()[k], column(orthonormal_, k), error);
    const std::size_t next = largest(error);
    if (std::abs(error[next]) < least) {
      least = std::abs(error[next]);
      best = reference.coefficient();
    }
    if (least <= (1.0 + limits.excess) * result.lower_bound + rounding || result.steps == limits.steps) break;
    reference.exchange(next, error[next] < 0.0 ? -1.0 : 1.0);
    ++result.steps;
  }
  std::vector<double> coefficient = columnCoefficients(best);
  least = errorOf(coefficient, wanted);
  if (least < result.error) {
    result.error = least;
    result.coefficient = std::move(coefficient);
  }
  result.lower_bound = std::min(result.lower_bound, result.error);
  return result;
}

}  // namespace welkin::sh
