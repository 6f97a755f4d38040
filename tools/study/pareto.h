// SPDX-License-Identifier: Apache-2.0
// The Pareto front of trades between cost and error: those that no other beats in both.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace welkin::study {

/// A way of doing something: less is better in both.
struct Trade {
  double cost;
  double error;
};

/// Indices of the trades on the front, cost rising and error falling strictly. Of equal trades the first is on it.
/// O(n log n). Throws Error(internal) for a NaN.
std::vector<std::size_t> paretoFront(std::span<const Trade> trades);

}  // namespace welkin::study
