// SPDX-License-Identifier: Apache-2.0
// Every place of a sector that could have a probe, and every point that has to see one.
#pragma once

#include <optional>
#include <vector>

#include "probes/geometry/tracer.h"
#include "probes/placement/checkpoint.h"
#include "probes/placement/settings.h"

namespace welkin::placement {

using f64::Number3;

struct Candidate {
  Number3 position;
  bool by_hand = false;
};

/// A point that has to see a probe: 0.1 m above ground that is no steeper than 60 degrees.
struct WalkablePoint {
  Number3 foot;
  Number3 above;           ///< where a probe of its own would stand
  bool on_lattice = true;  ///< and a candidate, if it may; else between the lines
};

struct Candidates {
  std::vector<Candidate> candidate;     ///< valid places, the preferred first
  std::vector<WalkablePoint> walkable;  ///< of the lattice, then of the one of half the spacing between its lines
  std::vector<double> ground_y;         ///< of all ground
};

/// By hand; above ground of the lattice, lines with both numbers even first, then both odd, then the rest; above
/// vegetation. Where neither lattice meets ground, lines through the middles of the sector's walkable triangles take
/// their place. `top_y` as in spansAt.
Candidates candidatesOf(const geometry::Tracer& tracer, const geometry::SectorId& id, const PlacementSettings& settings,
                        double top_y, PlacementReport& report, const Checkpoint& checkpoint = {});

/// A probe for a walkable point between the lines, moved and reported as candidates are; none where it may not stand.
std::optional<Candidate> candidateFor(const geometry::Tracer& tracer, const geometry::SectorId& id,
                                      const PlacementSettings& settings, const WalkablePoint& point,
                                      PlacementReport& report);

}  // namespace welkin::placement
