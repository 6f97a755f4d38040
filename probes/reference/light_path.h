// SPDX-License-Identifier: Apache-2.0
// Traces one path of the reference.
#pragma once

#include "probes/geometry/random.h"
#include "probes/reference/reference.h"

namespace welkin::reference {

using f64::Number3;

/// Light by source.
struct LightShares {
  Number3 sky{0.0};
  Number3 sun_bounce{0.0};
  Number3 local{0.0};
};

/// Everything that the paths of one point share. All of it must outlive the object.
struct PathScene {
  const geometry::Tracer& tracer;
  const DistantLight& distant;
  std::span<const LocalLight> lights;
  int bounces;
  Number3 ground_under_own_lights{0.0};  ///< radiance of the ground beyond the level, by directional lights
};

PathScene pathScene(const geometry::Tracer& tracer, const DistantLight& distant, std::span<const LocalLight> lights,
                    int bounces);

/// Irradiance that one path from a surface point finds, pi included. Its mean over s and t, uniform in [0, 1), and over
/// `random` is the irradiance. Only position and normal of `start` are needed.
LightShares tracePath(const PathScene& scene, const geometry::Hit& start, double s, double t, geometry::Random& random);

/// Mean of strata x strata paths, stratified over the directions at their start. Different batches are independent.
LightShares meanOfBatch(const PathScene& scene, const geometry::Hit& start, std::size_t strata, std::uint64_t seed,
                        std::size_t batch);

/// Irradiance straight from the sun, the moon, the local lights and the level's own, with their shadows. Of a local
/// light with a radius it is that of its middle.
Number3 directIrradiance(const PathScene& scene, const geometry::Hit& at);

/// Irradiance of one side of a surface by a local light, including its shadow, seen from `origin` just off the surface.
/// Its mean over s and t is the irradiance.
Number3 localIrradiance(const geometry::Tracer& tracer, const LocalLight& light, const Number3& origin,
                        const Number3& normal, double s, double t);

}  // namespace welkin::reference
