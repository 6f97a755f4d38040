// SPDX-License-Identifier: Apache-2.0
#include "sh/exchange.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "sh/dot.h"

namespace welkin::sh {

std::size_t largest(std::span<const double> value) {
  std::size_t at = 0;
  for (std::size_t i = 1; i < value.size(); ++i)
    if (std::abs(value[i]) > std::abs(value[at])) at = i;
  return at;
}

bool Reference::start(std::span<const double> preference) {
  std::vector<double> left(columns_.begin(), columns_.end());
  const auto column = [&](std::size_t k) { return std::span(left).subspan(k * points_, points_); };
  for (std::size_t k = 0; k <= rank(); ++k)
    for (std::size_t i = 0; i < points_; ++i) left[k * points_ + i] *= preference[i];
  for (std::size_t k = 0; k <= rank(); ++k) {
    point_[k] = largest(column(k));
    const double pivot = column(k)[point_[k]];
    if (pivot == 0.0) return false;
    for (std::size_t j = k + 1; j <= rank(); ++j) addMultiple(-column(j)[point_[k]] / pivot, column(k), column(j));
  }
  SmallMatrix matrix{};
  SmallVector last{};
  for (std::size_t k = 0; k < rank(); ++k) {
    for (std::size_t i = 0; i < rank(); ++i) matrix[i][k] = entry(point_[i], k);
    last[k] = -entry(point_[rank()], k);
  }
  if (!factors_.eliminate(matrix, rank())) return false;
  SmallVector multiplier = factors_.solveTransposed(last);
  multiplier[rank()] = 1.0;
  double level = 0.0;
  for (std::size_t i = 0; i <= rank(); ++i) level += multiplier[i] * entry(point_[i], rank());
  for (std::size_t i = 0; i <= rank(); ++i) sign_[i] = (multiplier[i] < 0.0) == (level < 0.0) ? 1.0 : -1.0;
  return true;
}

bool Reference::solve() {
  SmallMatrix matrix{};
  SmallVector wanted{};
  SmallVector unit{};
  for (std::size_t i = 0; i <= rank(); ++i) {
    for (std::size_t k = 0; k < rank(); ++k) matrix[i][k] = entry(point_[i], k);
    matrix[i][rank()] = sign_[i];
    wanted[i] = entry(point_[i], rank());
  }
  unit[rank()] = 1.0;
  if (!factors_.eliminate(matrix, rank() + 1)) return false;
  coefficient_ = factors_.solve(wanted);
  multiplier_ = factors_.solveTransposed(unit);
  double level = 0.0;
  double size = 0.0;
  for (std::size_t i = 0; i <= rank(); ++i) {
    level += multiplier_[i] * wanted[i];
    size += std::abs(multiplier_[i]);
  }
  bound_ = std::abs(level) / size;
  return true;
}

void Reference::exchange(std::size_t at, double sign) {
  constexpr double kNone = 1e-12;  // of multipliers, which add up to 1, and of the largest share
  SmallVector entering{};
  for (std::size_t k = 0; k < rank(); ++k) entering[k] = entry(at, k);
  entering[rank()] = sign;
  SmallVector falls = factors_.solveTransposed(entering);
  double most = 0.0;
  for (std::size_t i = 0; i <= rank(); ++i) {
    falls[i] *= sign * sign_[i];
    most = std::max(most, falls[i]);
  }
  std::size_t leaving = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i <= rank(); ++i) {
    if (falls[i] <= kNone * most) continue;
    const double multiplier = sign_[i] * multiplier_[i];
    const double ratio = multiplier <= kNone ? 0.0 : multiplier / falls[i];
    if (ratio < least || (ratio == least && falls[i] > falls[leaving])) {
      least = ratio;
      leaving = i;
    }
  }
  point_[leaving] = at;
  sign_[leaving] = sign;
}

}  // namespace welkin::sh
