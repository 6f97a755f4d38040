// SPDX-License-Identifier: Apache-2.0
// Light through surfaces that are glass or blended. It goes straight on: a surface passes a coloured share, reflects a
// diffuse one and keeps the rest. `Rays` is Tracer or a class with its interface.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "probes/geometry/tracer.h"

namespace welkin::geometry {

using f64::Number3;

/// Surfaces that a ray passes at most. A ray that meets more ends at the next one, as at an opaque surface.
inline constexpr int kMostPassed = 256;

/// Share of the light from a direction that arrives past everything up to `far`, linear, in [0, 1].
template <typename Rays>
Number3 arrivingShare(const Rays& rays, Number3 origin, const Number3& direction, double far) {
  if (!rays.anySeeThrough()) return Number3(rays.occluded(origin, direction, far) ? 0.0 : 1.0);
  Number3 share(1.0);
  for (int passed = 0; passed <= kMostPassed; ++passed) {
    const auto hit = rays.closest(origin, direction, far, Meets::light);
    if (!hit) return share;
    share = share * rays.passing(*hit);
    if (share == Number3(0.0)) return share;
    origin = rays.beyond(*hit);
    far -= hit->distance;
  }
  return Number3(0.0);
}

/// The surface that a path meets in a direction, and the light that passes on the way.
struct Sight {
  std::optional<Hit> hit;  ///< the surface that reflects the path; nothing where it leaves the level
  Number3 weight{1.0};     ///< of the path from here on
  Number3 emission{0.0};   ///< radiance of all surfaces that it met
};

/// Follows a path to the next surface that reflects it. At each surface that light passes it draws whether to pass, in
/// proportion to the largest channels of both shares; `draw` gives numbers in [0, 1) and is asked there alone. The mean
/// of what follows times `weight` is unbiased, and no weight is above 1. `emissive`: whether any surface emits.
template <typename Rays, typename Draw>
Sight lookAlong(const Rays& rays, Number3 origin, const Number3& direction, bool emissive, const Draw& draw) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Sight sight;
  if (!rays.anySeeThrough()) {
    sight.hit = rays.closest(origin, direction, kFar);
    if (emissive && sight.hit) sight.emission = rays.emission(*sight.hit);
    return sight;
  }
  const auto largest = [](const Number3& v) { return std::max({v.x, v.y, v.z}); };
  for (int passed = 0;; ++passed) {
    sight.hit = rays.closest(origin, direction, kFar, Meets::light);
    if (!sight.hit) return sight;
    if (emissive) sight.emission += sight.weight * rays.emission(*sight.hit);
    const Number3 passing = passed < kMostPassed ? rays.passing(*sight.hit) : Number3(0.0);
    const double passes = largest(passing);
    if (passes == 0.0) return sight;
    const double reflects = largest(rays.albedo(*sight.hit));
    const double both = passes + reflects;
    if (reflects > 0.0 && !(draw() * both < passes)) {
      sight.weight = sight.weight * (both / reflects);
      return sight;
    }
    sight.weight = sight.weight * passing * (both / passes);
    origin = rays.beyond(*sight.hit);
  }
}

}  // namespace welkin::geometry
