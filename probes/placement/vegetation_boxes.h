// SPDX-License-Identifier: Apache-2.0
// Places for probes above vegetation, found from its boxes, not from its leaves.
#pragma once

#include <vector>

#include "probes/geometry/surfaces.h"
#include "probes/placement/settings.h"

namespace welkin::placement {

using f64::Number3;

/// The world box of every vegetation object, in the order of the objects; none for an object without triangles.
std::vector<geometry::Box> vegetationBoxes(const geometry::Surfaces& surfaces);

/// Places of one sector above the boxes. First comes the highest box at each line of the lattice of
/// vegetation_spacing_m, then the middle of each box that no line meets.
std::vector<Number3> aboveVegetation(const std::vector<geometry::Box>& boxes, const PlacementSettings& settings,
                                     const geometry::SectorId& id);

/// Sectors where aboveVegetation finds a place for the box, each once.
std::vector<geometry::SectorId> sectorsOfVegetation(const geometry::Box& box, const PlacementSettings& settings);

}  // namespace welkin::placement
