// SPDX-License-Identifier: Apache-2.0
// Selects probes among candidates: apart from each other, in sight of every walkable point, at most kMostProbes.
#pragma once

#include "probes/placement/candidates.h"
#include "sky/base/progress.h"

namespace welkin::placement {

/// The probes in their final order, selected in three steps.
/// 1. A candidate is dropped if a probe of the same room is within minimum_separation_m and sees it. So two storeys, or
/// the two sides of a wall, do not thin each other.
/// 2. Every walkable point without a probe in sight within coverage_m gets the nearest candidate that it sees, or a
/// probe of its own.
/// 3. thin() removes the excess.
/// Memory grows with the candidates and walkable points, not with the number of pairs that see each other.
std::vector<geometry::Probe> selectProbes(const geometry::Tracer& tracer, const geometry::SectorId& id,
                                          const Candidates& candidates, const PlacementSettings& settings,
                                          PlacementReport& report, const base::Progress& progress = {});

}  // namespace welkin::placement
