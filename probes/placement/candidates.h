// SPDX-License-Identifier: Apache-2.0
// Every place of a sector that could have a probe, and every point that has to see one.
#pragma once

#include <optional>
#include <vector>

#include "probes/placement/settings.h"
#include "probes/tracer.h"

namespace welkin::probes {

struct Candidate {
  Number3 position;
  bool by_hand = false;
};

struct Candidates {
  std::vector<Candidate> candidate;  ///< valid places, the preferred first
  std::vector<Number3> walkable;     ///< 0.1 m above the ground of each line of the lattice, storeys from below
  std::vector<double> ground_y;      ///< of all ground
};

/// By hand; above ground of the lattice, lines with both numbers even first, then both odd, then the rest; above
/// vegetation. `top_y` as in spansAt.
Candidates candidatesOf(const Tracer& tracer, const SectorId& id, const PlacementSettings& settings, double top_y,
                        PlacementReport& report);

}  // namespace welkin::probes
