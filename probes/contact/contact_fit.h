// SPDX-License-Identifier: Apache-2.0
// Contact factors: one number a vertex of static geometry, by which a game multiplies the probes' light there. They
// hold what lies between probes, which are metres apart: the dark under a hut, at the foot of a wall, in a niche.
// Factors are fitted to traced light over the triangles that they shade, through the runtime's own look-up of the
// probes (Kavan, Bargteil and Sloan, "Least Squares Vertex Baking", EGSR 2011).
#pragma once

#include <cstdint>
#include <vector>

#include "probes/contact/contact_points.h"
#include "probes/sectors/sector_file.h"
#include "sky/base/progress.h"
#include "sky/model/sky.h"

namespace welkin::contact {

/// Steps of a factor of 1: a byte of 170 leaves the probes' light as it is, and 255 is a factor of 1.5.
inline constexpr double kSteps = 170.0;

struct ContactSettings {
  int bounces = 2;           ///< as the probes'
  double reach_m = 0.0;      ///< as the probes', > 0
  double spacing_m = 0.7;    ///< of the points on large triangles
  std::uint32_t paths = 32;  ///< of a point
};

/// The bytes of all vertices of PlacedVertices, for the lights of ContactLights. Vertices of triangles that no probe
/// serves, that lie within bodies or under water have 170. `tracer` is that of the whole level, and the sectors are all
/// of it. Runs on all threads of the caller's arena; the result is the same for any number of them.
std::vector<std::uint8_t> fitContact(const geometry::Tracer& tracer, const model::Sky& sky,
                                     const std::vector<sectors::SectorFile>& sectors, const PlacedVertices& vertices,
                                     const ContactSettings& settings, const base::Progress& progress = {});

}  // namespace welkin::contact
