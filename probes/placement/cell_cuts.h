// SPDX-License-Identifier: Apache-2.0
// Cuts the cells of a sector along walls, so that no filter crosses one.
#pragma once

#include "probes/geometry/tracer.h"
#include "probes/placement/cut_samples.h"
#include "probes/placement/sector_cuts.h"
#include "sky/base/progress.h"

namespace welkin::placement {

/// The cuts of a placed sector. Only cells with static geometry in or beside them can have one. `look` is the light of
/// each probe: where something small parts two that have nearly the same, it does not matter which of them serves. With
/// `lamps_come` it does matter, unless they see each other, as lamps of the game may light one of them alone. No
/// neighbour's result takes part: whether a cell of another sector is open depends on geometry alone.
SectorCuts cutCells(const geometry::Tracer& tracer, const geometry::PlacedSector& sector,
                    const std::vector<ProbeLook>& look, bool lamps_come, const base::Progress& progress = {});

}  // namespace welkin::placement
