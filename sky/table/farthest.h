// SPDX-License-Identifier: Apache-2.0
// Finds the farthest end of a run for which a test holds, when longer runs cost more to test and seldom hold again.
#pragma once

#include <algorithm>
#include <cstddef>

namespace welkin::table {

/// Returns the largest index found, at most `last`, with `holds(index)`. The search gallops from `first`, by `step`,
/// twice that and so on, until the test fails, then bisects. `first` + 1 is assumed to hold. `step` >= 1.
template <typename Holds>
std::size_t farthest(std::size_t first, std::size_t last, std::size_t step, const Holds& holds) {
  std::size_t good = first + 1;
  std::size_t bad = last + 1;
  for (; good < last; step *= 2) {
    const std::size_t next = std::min(std::max(first + step, good + 1), last);
    if (!holds(next)) {
      bad = next;
      break;
    }
    good = next;
  }
  while (good + 1 < bad && good < last) {
    const std::size_t middle = good + (bad - good) / 2;
    (holds(middle) ? good : bad) = middle;
  }
  return good;
}

}  // namespace welkin::table
