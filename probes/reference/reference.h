// SPDX-License-Identifier: Apache-2.0
// The ground truth of probes: irradiance at any point and normal by plain path tracing, with the standard error of
// every number. It uses no spherical harmonics or tables (Kajiya, "The Rendering Equation", 1986).
//
// A path starts at the point and bounces off diffuse surfaces. At each surface it tests the sun, the moon, every local
// light and every light of the level directly (next-event estimation). The sky, the ground beyond the level and
// emissive surfaces count where the path meets them. Light bounces off at most `bounces` surfaces between its source
// and the point, including the ground beyond the level.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "probes/geometry/tracer.h"
#include "probes/reference/distant_light.h"
#include "sky/base/progress.h"

namespace welkin::reference {

using f64::Number3;

/// A dynamic light that shines equally in all directions. It stops no rays, and rays do not see it.
struct LocalLight {
  Number3 position;
  Number3 intensity;      ///< radiant intensity, scene units
  double radius_m = 0.0;  ///< radius of the glowing sphere, >= 0; 0: a point
};

struct ReferenceSettings {
  std::size_t samples = 65536;  ///< paths, rounded up to whole batches; there are at least 64 batches
  int bounces = 2;              ///< >= 0
  std::uint64_t seed = 0;       ///< different seeds draw independent paths
};

struct Estimate {
  Number3 value{0.0};
  Number3 standard_error{0.0};
};

/// Irradiance of one side of a surface, pi included, scene units.
struct ReferenceIrradiance {
  Estimate sky;         ///< from the sky, direct and bounced
  Estimate sun_bounce;  ///< from the sun and the moon, bounced only
  Estimate local;       ///< from local lights and the level's own, bounced only, and emissive surfaces, direct too
  Estimate total;       ///< the sum; its standard error allows for one path feeding all three
  std::size_t samples = 0;
};

/// Number of batches that traceReference reports to its progress.
std::size_t referenceBatches(const ReferenceSettings& settings);

/// Traces in parallel (oneTBB's current arena), with the same bits for any number of threads. `normal` is a unit
/// vector. The point may lie on a surface: rays start off it, on the normal's side. Batches are independent, and each
/// is stratified over the directions at the point. The standard error is the error of their mean.
ReferenceIrradiance traceReference(const geometry::Tracer& tracer, const DistantLight& distant,
                                   std::span<const LocalLight> lights, const Number3& position, const Number3& normal,
                                   const ReferenceSettings& settings, const base::Progress& progress = {});

}  // namespace welkin::reference
