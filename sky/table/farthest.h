// SPDX-License-Identifier: Apache-2.0
// The farthest end of a run that holds, where longer runs are dearer to try and seldom hold again.
#pragma once

#include <algorithm>
#include <cstddef>

namespace welkin::table {

/// The largest index that a search finds from `first` on with `holds(index)`, at most `last`: it gallops, steps of
/// `step`, twice that and so on, until one does not hold, then bisects. `first` + 1 holds untried. `step` >= 1.
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
