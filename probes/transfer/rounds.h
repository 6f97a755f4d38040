// SPDX-License-Identifier: Apache-2.0
// How many paths a probe takes: a fixed number, or as many as bring its error within a budget.
#pragma once

#include <algorithm>
#include <cstdint>

namespace welkin::transfer {

/// Rounds of paths of every replicate, `most` of each at once, or, with max_error > 0, doubled from 32 until the error
/// is at most that. round(from, to) traces paths from <= i < to of every replicate and gives the error of all so far.
/// Returns how many of a replicate were traced.
template <typename Round>
std::uint32_t traceRounds(std::uint32_t most, double max_error, const Round& round) {
  constexpr std::uint32_t kFirst = 32;  // of a replicate: fewer say too little of the error
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
