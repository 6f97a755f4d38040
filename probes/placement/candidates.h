// SPDX-License-Identifier: Apache-2.0
// Collects the places of a sector where a probe may stand, and the points that must see a probe.
#pragma once

#include <optional>
#include <vector>

#include "probes/geometry/tracer.h"
#include "probes/placement/settings.h"
#include "sky/base/progress.h"

namespace welkin::placement {

using f64::Number3;

struct Candidate {
  Number3 position;
  bool by_hand = false;
};

/// A point that must see a probe: 0.1 m above ground that is no steeper than 60 degrees.
struct WalkablePoint {
  Number3 foot;
  Number3 above;           ///< where the point's own probe would stand
  bool on_lattice = true;  ///< true: on the lattice, and a candidate if a probe may stand there; false: between lines
};

struct Candidates {
  std::vector<Candidate> candidate;     ///< valid places, preferred ones first
  std::vector<WalkablePoint> walkable;  ///< lattice points, then those of the lattice twice as fine
  std::vector<double> ground_y;         ///< heights of all ground
  std::size_t search_rays = 0;          ///< rays that further searches for free places may take
};

/// Rays that the searches of a sector for free places take at most, but for the last ones begun. In a soup of triangles
/// nearly all places look for another, and the time of a ray grows with the surfaces on a line. So these are the rays
/// where the lines of the lattice meet 32 spans of air or less on average; where they meet more, fewer in proportion.
inline constexpr std::size_t kMostSearchRays = std::size_t{1} << 19;

/// Candidates in this order: by hand; above ground of the lattice; above vegetation. On the lattice, lines with both
/// numbers even come first, then both odd, then the rest. If neither lattice meets ground, lines through the middles of
/// the sector's walkable triangles take their place. `top_y` as in spansAt.
Candidates candidatesOf(const geometry::Tracer& tracer, const geometry::SectorId& id, const PlacementSettings& settings,
                        double top_y, PlacementReport& report, const base::Progress& progress = {});

/// A candidate for a walkable point between the lines, moved and reported as others are. Nothing if no probe may stand
/// there. Takes from `search_rays`; without any left, a place that is not free gets none.
std::optional<Candidate> candidateFor(const geometry::Tracer& tracer, const geometry::SectorId& id,
                                      const PlacementSettings& settings, const WalkablePoint& point,
                                      PlacementReport& report, std::size_t& search_rays);

}  // namespace welkin::placement
