// SPDX-License-Identifier: Apache-2.0
// Ground under a roof that the lattices may miss, such as that of a narrow corridor.
#pragma once

#include "probes/placement/candidates.h"

namespace welkin::placement {

/// Points under a roof on a lattice of half a metre, in the order of the triangles below them. There is headroom above
/// each, and ground that is not too steep below. At most kMostNarrow, evenly chosen.
std::vector<WalkablePoint> narrowGround(const geometry::Tracer& tracer, const geometry::SectorId& id,
                                        const PlacementSettings& settings, const base::Progress& progress);

/// Points of the lattice that are looked at.
inline constexpr std::size_t kMostNarrow = std::size_t{1} << 16;

}  // namespace welkin::placement
