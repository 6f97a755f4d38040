// SPDX-License-Identifier: Apache-2.0
// The free spans of a vertical line through a level, with air and the ground below it.
#pragma once

#include <vector>

#include "probes/geometry/sector.h"
#include "probes/geometry/tracer.h"

namespace welkin::placement {

/// Offsets of the cells' lines from the round numbers where levels have their edges. A ray along an exact lattice meets
/// shared edges, and may slip through each of them.
inline constexpr double kAside_x_m = 0.0371;
inline constexpr double kAside_z_m = 0.0213;

/// Air between two surfaces of static geometry, metres; infinite on a side without a surface.
struct Span {
  double low_y;
  double high_y;
  double floor_normal_y = 0.0;  ///< of the surface below, in (0, 1]; 0 if there is none
  bool inside = false;          ///< inside a body whose bottom or top faces the wrong way, so it is no air
  bool hasFloor() const { return floor_normal_y > 0.0; }
};

/// All spans at (x, z) from the lowest to the highest. `top_y` must be above all static geometry there. A one-sided
/// surface bounds only the air in front of it; insideGeometry decides about the space between a front and a back.
/// Surfaces within 1 mm count as one. Spans lower than `least_m` are not asked whether they are inside: no more than
/// height / least_m can be, however many triangles there are. Nor are those but the 2048 / n highest on a line that
/// crosses n > 64 surfaces: in a soup of triangles the time of a ray grows with n. Spans above ground that are not
/// asked count as air.
std::vector<Span> spansAt(const geometry::Tracer& tracer, double x, double z, double top_y, double least_m = 0.0);

/// A height above all static triangles over the sector's square; nothing if there are none.
std::optional<double> topOver(const geometry::Surfaces& surfaces, const geometry::SectorId& id);

}  // namespace welkin::placement
