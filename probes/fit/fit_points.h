// SPDX-License-Identifier: Apache-2.0
// The places of a sector whose light matters: its static surfaces, and the air where characters walk.
#pragma once

#include <cstdint>
#include <vector>

#include "probes/geometry/sector.h"
#include "probes/geometry/tracer.h"

namespace welkin::fit {

using f64::Number3;

struct FitPoint {
  Number3 position;
  Number3 normal;  ///< unit
};

struct FitPoints {
  std::vector<FitPoint> surface;  ///< spread by area over the fronts of static surfaces
  std::vector<FitPoint> air;      ///< 0.3 to 2 m above ground up to 60 degrees, normals uniform over the sphere
  double surface_m2 = 0.0;        ///< area that `surface` stands for, estimated from the draws
  double air_m2 = 0.0;            ///< area of ground that `air` stands for
};

/// Draws random points of a sector: `surface` and `air` of them, or fewer where there is little of either. Surfaces
/// under water and inside of bodies do not count, nor do those that carry no vertex within the sector's square or cross
/// it. The same seed gives the same points; another seed gives independent ones.
FitPoints pointsOf(const geometry::Tracer& tracer, geometry::SectorId sector, std::size_t surface, std::size_t air,
                   std::uint64_t seed);

}  // namespace welkin::fit
