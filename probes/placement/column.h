// SPDX-License-Identifier: Apache-2.0
// The free spans of a vertical line through a level: where there is air, and ground under it.
#pragma once

#include <vector>

#include "probes/geometry/sector.h"
#include "probes/geometry/tracer.h"

namespace welkin::placement {

/// The lines of cells stand this much beside the round numbers on which levels have their edges: a ray along an exact
/// lattice meets shared edges, and each of those is a chance to slip through.
inline constexpr double kAside_x_m = 0.0371;
inline constexpr double kAside_z_m = 0.0213;

/// Air between two surfaces of static geometry, metres; infinite where there is none.
struct Span {
  double low_y;
  double high_y;
  double floor_normal_y = 0.0;  ///< of the surface below, (0, 1]; 0 where there is none
  bool inside = false;          ///< of a body whose bottom or top faces the wrong way: no air
  bool hasFloor() const { return floor_normal_y > 0.0; }
};

/// All spans at (x, z) from the lowest to the highest; `top_y` is above all static geometry there. A surface with one
/// side bounds air in front of it only; what lies between a front and a back is decided by insideGeometry. Surfaces
/// within 1 mm are one.
std::vector<Span> spansAt(const geometry::Tracer& tracer, double x, double z, double top_y);

/// Above all static triangles over the sector's square; no value where there are none.
std::optional<double> topOver(const geometry::Surfaces& surfaces, const geometry::SectorId& id);

}  // namespace welkin::placement
