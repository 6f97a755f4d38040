// SPDX-License-Identifier: Apache-2.0
// One path of the reference.
#pragma once

#include "probes/geometry/random.h"
#include "probes/reference/reference.h"

namespace welkin::reference {

using f64::Number3;

/// Light by what it comes from.
struct LightShares {
  Number3 sky{0.0};
  Number3 sun_bounce{0.0};
  Number3 local{0.0};
};

/// What every path of one point shares; all of it outlives the object.
struct PathScene {
  const geometry::Tracer& tracer;
  const DistantLight& distant;
  std::span<const LocalLight> lights;
  int bounces;
};

/// Irradiance that one path from a point of a surface finds, pi included: its mean over s and t, uniform in [0, 1), and
/// over `random` is the irradiance. `start` needs only position and normal.
LightShares tracePath(const PathScene& scene, const geometry::Hit& start, double s, double t, geometry::Random& random);

/// Irradiance of one side of a surface by a local light, its shadow included, seen from `origin` just off the surface;
/// the mean over s and t.
Number3 localIrradiance(const geometry::Tracer& tracer, const LocalLight& light, const Number3& origin,
                        const Number3& normal, double s, double t);

}  // namespace welkin::reference
