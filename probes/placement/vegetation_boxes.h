// SPDX-License-Identifier: Apache-2.0
// Vegetation is placed by its boxes, not by its leaves.
#pragma once

#include <vector>

#include "probes/geometry/surfaces.h"
#include "probes/placement/settings.h"

namespace welkin::placement {

using f64::Number3;

/// The world box of every object of vegetation, in the order of the objects; none for one without triangles.
std::vector<geometry::Box> vegetationBoxes(const geometry::Surfaces& surfaces);

/// Places above the boxes: at each line of the lattice of vegetation_spacing_m the highest box there, and the middle of
/// each box that no line meets. Those of a sector only, in that order.
std::vector<Number3> aboveVegetation(const std::vector<geometry::Box>& boxes, const PlacementSettings& settings,
                                     const geometry::SectorId& id);

/// Sectors that aboveVegetation has places of a box in, each once.
std::vector<geometry::SectorId> sectorsOfVegetation(const geometry::Box& box, const PlacementSettings& settings);

}  // namespace welkin::placement
