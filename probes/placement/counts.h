// SPDX-License-Identifier: Apache-2.0
// The part of a PlacementReport that a sector's file keeps. A sector that is not baked again reports the same.
#pragma once

#include "probes/placement/settings.h"

namespace welkin::placement {

using f64::Number3;

/// Limits of named places: the first of each kind, and the first by hand of all kinds.
inline constexpr std::size_t kMostNamed = 4;
inline constexpr std::size_t kMostNamedByHand = 16;

/// A place without a probe, a place whose probe was moved, or a walkable point that sees no probe.
struct NamedPlace {
  enum class Kind : std::uint8_t { inside, too_close, thinned, uncovered, moved };
  Number3 position;      ///< the wanted position; in a sector's file, x and z count from the sector's corner
  double moved_m = 0.0;  ///< distance; > 0 if the probe was moved, else 0
  Kind kind = Kind::inside;
  bool by_hand = false;
  friend bool operator==(const NamedPlace& a, const NamedPlace& b) {
    return a.position == b.position && a.moved_m == b.moved_m && a.kind == b.kind && a.by_hand == b.by_hand;
  }
};

/// The place of a sector's file in the world: x and z of the file count from the sector's corner. To a micrometre, so
/// that a place by hand has the digits that the level file gives it.
Number3 placeInWorld(geometry::SectorId sector, const NamedPlace& place);

struct PlacementCounts {
  std::size_t columns = 0, ground = 0, walkable = 0, moved = 0, inside = 0, too_close = 0, thinned = 0, uncovered = 0,
              cells_without = 0;
  std::size_t by_hand_moved = 0, by_hand_dropped = 0;  ///< included in the counts above
  std::vector<NamedPlace> named;  ///< by kind, in the report's order; only those by hand among the moved ones
};

PlacementCounts countsOf(const PlacementReport& report);

}  // namespace welkin::placement
