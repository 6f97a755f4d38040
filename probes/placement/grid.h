// SPDX-License-Identifier: Apache-2.0
// Fills the grid that names, for every cell of a sector, the nearest probe that the cell can see.
#pragma once

#include "probes/geometry/tracer.h"
#include "probes/placement/settings.h"
#include "sky/base/progress.h"

namespace welkin::placement {

/// Fills low_y, cell_height_m, grid and top of a sector whose probes are placed. `ground_y` are heights that the grid
/// must contain besides the probes. The bottom and the cell height are whole multiples of kCell_m; the bottom counts
/// from the world's origin. A cell names the first of these, always in the same room as the point:
/// 1. the nearest probe that its middle sees, if the middle is in the air;
/// 2. the nearest probe to any point of its air that sees it;
/// 3. a probe round a corner, from a neighbouring cell: one cell's point sees the other's, and that point sees the
/// probe or the way to it. This runs in rounds, and the probe nearest to the middle comes first;
/// 4. for a cell without air, which only filtering reaches: the nearest probe of the 26 cells around it that all of
/// those with a probe see, so that filtering does not cross a wall;
/// 5. kNoProbe.
/// No line of sight crosses static geometry.
void fillGrid(const geometry::Tracer& tracer, const PlacementSettings& settings, const std::vector<double>& ground_y,
              double top_y, geometry::PlacedSector& sector, PlacementReport& report,
              const base::Progress& progress = {});

}  // namespace welkin::placement
