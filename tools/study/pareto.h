// SPDX-License-Identifier: Apache-2.0
// The Pareto front of cost and error: the tradeoffs that no other one beats in both.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace welkin::study {

/// A cost and an error: less is better in both.
struct Tradeoff {
  double cost;
  double error;
};

/// Indices of the tradeoffs on the front, cost rising and error falling strictly. Of equal tradeoffs the first is on
/// it. O(n log n). Throws Error(internal) for a NaN.
std::vector<std::size_t> paretoFront(std::span<const Tradeoff> tradeoffs);

}  // namespace welkin::study
