// SPDX-License-Identifier: Apache-2.0
// Ground between the lines of the lattice: the parts of triangles over a sector.
#pragma once

#include <array>
#include <vector>

#include "probes/geometry/sector.h"
#include "probes/geometry/surfaces.h"

namespace welkin::placement {

using f64::Number3;

/// Ground is walkable up to 60 degrees. This is the smallest y of its normal.
inline constexpr double kWalkable_normal_y = 0.5;

/// Smallest area of walkable ground in a sector that counts: 0.1 m square.
inline constexpr double kLeastGround_m2 = 0.01;

/// The part of a triangle over a sector's square, seen from above, and its centroid.
struct GroundPart {
  double area_m2 = 0.0;  ///< 0 if no part is over the sector
  double x = 0.0;
  double z = 0.0;
};

std::array<Number3, 3> cornersOf(const geometry::Surfaces& surfaces, const geometry::Triangle& triangle);

/// Whether a triangle, or one of its sides if it has `two_sides`, is ground up to 60 degrees.
bool isWalkable(const std::array<Number3, 3>& corner, bool two_sides);

GroundPart partOver(const std::array<Number3, 3>& corner, const geometry::SectorId& id);

/// The parts of all walkable triangles over a sector, the largest first, at most kMostProbes. Empty if their total is
/// less than kLeastGround_m2.
std::vector<GroundPart> walkableParts(const geometry::Surfaces& surfaces, const geometry::SectorId& id);

}  // namespace welkin::placement
