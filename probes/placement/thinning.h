// SPDX-License-Identifier: Apache-2.0
// Which probes a sector can do without.
#pragma once

#include <cstddef>
#include <vector>

namespace welkin::probes {

/// A probe that a walkable point sees, by index, metres away.
struct SeenProbe {
  std::size_t probe;
  double distance_m;
};

/// For each walkable point the probes that it sees within reach, from the nearest.
using Coverage = std::vector<std::vector<SeenProbe>>;

/// Takes probes away, one by one, until `most` are left: each time the one whose loss is least. Loss is the number of
/// points that see no probe any more, then by how much the distances to the nearest probe seen grow in all, then the
/// index (the later goes first). Probes that `by_hand` marks go when no others are left. Returns their indices in the
/// order in which they go.
std::vector<std::size_t> thin(const Coverage& coverage, const std::vector<bool>& by_hand, std::size_t most);

}  // namespace welkin::probes
