// SPDX-License-Identifier: Apache-2.0
// Pictures of a level's placement and grid: the places of the probes, and the cells that each probe serves.
#pragma once

#include <string>
#include <vector>

#include "probes/geometry/sector.h"
#include "probes/geometry/tracer.h"

namespace welkin::picture {

/// Draws the level from above, north up, in greys: higher is lighter, steeper is darker, nothing is white. Adds the
/// borders of sectors, every probe, and a line from each cell's middle to the probe for surfaces seen from above.
/// Returns the bytes of a PNG with sides of at most 2000 pixels. Throws Error(internal) if memory runs out.
std::string drawFromAbove(const geometry::Tracer& tracer, const std::vector<geometry::PlacedSector>& sectors);

/// Draws the section at `z` metres, looking north, with east to the right. The inside of geometry is grey. A line goes
/// from the middle of each cell of that row to its probe; a cell without a probe has a cross. The section ends 8 m
/// above the highest probe shown. Result and errors as in drawFromAbove.
std::string drawSection(const geometry::Tracer& tracer, const std::vector<geometry::PlacedSector>& sectors, double z);

}  // namespace welkin::picture
