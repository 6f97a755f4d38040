// SPDX-License-Identifier: Apache-2.0
// Traces a fixed number of paths for a probe, or as many as keep its error within a budget.
#pragma once

#include <algorithm>
#include <cstdint>

namespace welkin::transfer {

/// Traces rounds of paths of every replicate: `most` at once, or, with max_error > 0, doubled from 32 until the error
/// is at most that. round(from, to) traces the paths from <= i < to of every replicate and returns the error of all
/// paths so far. Returns the number of paths traced per replicate.
template <typename Round>
std::uint32_t traceRounds(std::uint32_t most, double max_error, const Round& round) {
  constexpr std::uint32_t kFirst = 32;  // per replicate; fewer paths do not show the error well
  std::uint32_t done = 0;
  std::uint32_t next = max_error > 0.0 ? std::min(kFirst, most) : most;
  for (;;) {
    const double error = round(done, next);
    done = next;
    if (done == most || error <= max_error) return done;
    next = std::min(2 * done, most);
  }
}

}  // namespace welkin::transfer
