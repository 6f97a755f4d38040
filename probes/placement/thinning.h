// SPDX-License-Identifier: Apache-2.0
// Which probes a sector can do without.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace welkin::placement {

/// A probe that a walkable point sees, by index, metres away.
struct SeenProbe {
  std::size_t probe;
  double distance_m;
};

/// As many probes of a point are kept in memory; where all of them are gone the point looks again.
inline constexpr std::size_t kNearestSeen = 8;

/// The kNearestSeen probes nearest to a walkable point of those that it sees within reach and that are not gone, or all
/// where they are fewer; from the nearest. Called from any thread; what it throws ends the thinning.
using Look = std::function<std::vector<SeenProbe>(std::size_t point, const std::vector<bool>& gone)>;

/// Takes probes away, one by one, until `most` are left: each time the one whose loss is least. Loss is the number of
/// points that see no probe any more, then by how much the distances to the nearest probe seen grow in all, then the
/// index (the later goes first). Probes that `by_hand` marks go when no others are left. Returns their indices in the
/// order in which they go.
std::vector<std::size_t> thin(std::size_t points, const Look& look, const std::vector<bool>& by_hand, std::size_t most);

}  // namespace welkin::placement
