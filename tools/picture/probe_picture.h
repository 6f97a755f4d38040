// SPDX-License-Identifier: Apache-2.0
// Placement and grid of a level as pictures: where the probes are, and which cells each one serves.
#pragma once

#include <string>
#include <vector>

#include "probes/geometry/sector.h"
#include "probes/geometry/tracer.h"

namespace welkin::picture {

/// From above, north up: the level in greys (higher is lighter, steeper darker, white where there is nothing), the
/// borders of sectors, every probe, and a line from each cell's middle to the probe that serves what is seen there.
/// The bytes of a PNG of at most 2000 pixels a side. Throws Error(internal) when there is no memory.
std::string drawFromAbove(const geometry::Tracer& tracer, const std::vector<geometry::PlacedSector>& sectors);

/// Looking north at the plane of a z, metres: grey where the plane is inside geometry, a line from the middle of each
/// cell of that row to its probe, a cross where a cell has none. East is right; to 8 m above the highest probe named.
std::string drawSection(const geometry::Tracer& tracer, const std::vector<geometry::PlacedSector>& sectors, double z);

}  // namespace welkin::picture
