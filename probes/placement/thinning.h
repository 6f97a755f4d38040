// SPDX-License-Identifier: Apache-2.0
// Removes the probes that a sector needs least.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace welkin::placement {

/// A probe that a walkable point sees: its index and distance.
struct SeenProbe {
  std::size_t probe;
  double distance_m;
};

/// Number of probes kept in memory per point. When all of them are gone, the point looks again.
inline constexpr std::size_t kNearestSeen = 8;

/// Returns, nearest first, the kNearestSeen nearest probes that a walkable point sees within reach and that are not
/// gone; all of them if they are fewer. Called from any thread; an exception from it ends the thinning.
using Look = std::function<std::vector<SeenProbe>(std::size_t point, const std::vector<bool>& gone)>;

/// Removes probes one by one until `most` are left, each time the one of least loss. Loss is, first, the number of
/// points that no longer see a probe. Then it is the total growth of distances to the nearest probe seen, then the
/// index (the later goes first). Probes marked in `by_hand` go only when no others are left. Returns the indices in the
/// order of removal.
std::vector<std::size_t> thin(std::size_t points, const Look& look, const std::vector<bool>& by_hand, std::size_t most);

}  // namespace welkin::placement
