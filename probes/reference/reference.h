// SPDX-License-Identifier: Apache-2.0
// The ground truth of probes: irradiance at any point and normal by plain path tracing, without spherical harmonics or
// tables (Kajiya, "The Rendering Equation", 1986), with the standard error of every number.
//
// A path starts at the point and bounces off diffuse surfaces; at each of them the sun, the moon and every local light
// are asked for directly (next-event estimation), and what the path runs into by itself, the sky, the ground beyond the
// level and emissive surfaces, counts as found. Light bounces off at most `bounces` surfaces, the ground beyond the
// level included, between its source and the point.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "probes/geometry/tracer.h"
#include "probes/reference/distant_light.h"

namespace welkin::reference {

using f64::Number3;

/// A dynamic light that shines alike in all directions. It stops no rays, and rays do not see it.
struct LocalLight {
  Number3 position;
  Number3 intensity;      ///< radiant intensity, scene units
  double radius_m = 0.0;  ///< of its glowing sphere, >= 0; 0: a point
};

struct ReferenceSettings {
  std::size_t samples = 65536;  ///< paths; rounded up to whole batches, of which there are at least 64
  int bounces = 2;              ///< >= 0
  std::uint64_t seed = 0;       ///< other seeds draw independent paths
};

struct Estimate {
  Number3 value{0.0};
  Number3 standard_error{0.0};
};

/// Irradiance, pi included, of one side of a surface; scene units.
struct ReferenceIrradiance {
  Estimate sky;         ///< of the sky, direct and bounced
  Estimate sun_bounce;  ///< of the sun and the moon, bounced only
  Estimate local;       ///< of local lights, bounced only, and of emissive surfaces, direct and bounced
  Estimate total;       ///< their sum; its standard error counts that one path feeds all three
  std::size_t samples = 0;
};

/// Told after every finished batch, from any thread; returns false to stop, which throws Error(interrupted).
using ReferenceProgress = std::function<bool()>;

/// Number of batches that traceReference tells its progress of.
std::size_t referenceBatches(const ReferenceSettings& settings);

/// In parallel (oneTBB's current arena); the same bits for any number of threads. `normal` is a unit vector. The point
/// may lie on a surface: rays start off it, on the normal's side. Batches are independent and each is stratified over
/// the directions at the point; the standard error is that of their mean.
ReferenceIrradiance traceReference(const geometry::Tracer& tracer, const DistantLight& distant,
                                   std::span<const LocalLight> lights, const Number3& position, const Number3& normal,
                                   const ReferenceSettings& settings, const ReferenceProgress& progress = {});

}  // namespace welkin::reference
