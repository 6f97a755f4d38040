// SPDX-License-Identifier: Apache-2.0
// The grid that names for every cell of a sector the nearest probe that the cell can see.
#pragma once

#include "probes/geometry/tracer.h"
#include "probes/placement/checkpoint.h"
#include "probes/placement/settings.h"

namespace welkin::placement {

/// Fills low_y, cell_height_m, grid and top of a sector whose probes stand. `ground_y`: heights that the grid must hold
/// besides the probes'. The bottom is a whole multiple of kCell_m in the world, the cell height one of kCell_m.
/// A cell names the first of these, always of the room that the point is in:
/// 1. the nearest probe that its middle sees, if that is in the air;
/// 2. the nearest probe to any point of its air that sees it;
/// 3. round a corner: a probe of a cell beside, if a point of the one sees the point of the other that sees the probe
///    or the way to it (in rounds, the probe nearest to the middle first);
/// 4. a cell without air, which only filtering reaches: the nearest probe of the 26 cells about it that all of those
///    with a probe see, so that no wall is filtered through;
/// 5. kNoProbe. No line of sight crosses static geometry.
void fillGrid(const geometry::Tracer& tracer, const PlacementSettings& settings, const std::vector<double>& ground_y,
              double top_y, geometry::PlacedSector& sector, PlacementReport& report, const Checkpoint& checkpoint = {});

}  // namespace welkin::placement
