// SPDX-License-Identifier: Apache-2.0
// Which candidates become probes: apart from each other, in sight of every walkable point, at most kMostProbes.
#pragma once

#include "probes/placement/candidates.h"

namespace welkin::placement {

/// The probes' positions in their final order. A candidate is left out where a probe of the same room is within
/// minimum_separation_m and sees it: two storeys, or the two sides of a wall, do not thin each other. Then every
/// walkable point without a probe in sight within coverage_m gets the nearest candidate that it sees, or one of its
/// own. Then thin(). Memory goes with the candidates and walkable points, not with how many of them see each other.
std::vector<geometry::Probe> selectProbes(const geometry::Tracer& tracer, const geometry::SectorId& id,
                                          const Candidates& candidates, const PlacementSettings& settings,
                                          PlacementReport& report, const Checkpoint& checkpoint = {});

}  // namespace welkin::placement
