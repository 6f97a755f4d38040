// SPDX-License-Identifier: Apache-2.0
// Vegetation is placed by its boxes, not by its leaves.
#pragma once

#include <vector>

#include "probes/placement/settings.h"
#include "probes/surfaces.h"

namespace welkin::probes {

/// The world box of every object of vegetation, in the order of the objects; none for one without triangles.
std::vector<Box> vegetationBoxes(const Surfaces& surfaces);

/// Places above the boxes: at each line of the lattice of vegetation_spacing_m the highest box there, and the middle of
/// each box that no line meets. Those of a sector only, in that order.
std::vector<Number3> aboveVegetation(const std::vector<Box>& boxes, const PlacementSettings& settings,
                                     const SectorId& id);

/// Sectors that aboveVegetation has places of a box in, each once.
std::vector<SectorId> sectorsOfVegetation(const Box& box, const PlacementSettings& settings);

}  // namespace welkin::probes
