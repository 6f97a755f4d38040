// SPDX-License-Identifier: Apache-2.0
#include "probes/reference/light_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "probes/geometry/directions.h"
#include "probes/geometry/see_through.h"

namespace welkin::reference {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// The next direction of a path, and cos / pi over its density. 0 means that no light comes from there.
struct Turn {
  Number3 direction;
  double weight = 0.0;
};

/// Draws cosine-distributed directions, and a share of them about the sun where the sky is brightest. They are weighted
/// by both densities (the balance heuristic of Veach and Guibas, "Optimally Combining Sampling Techniques", 1995).
Turn turnAt(const DistantLight& distant, const Number3& normal, double s, double t, geometry::Random& random) {
  const double share = distant.lobeShare();
  if (share == 0.0) return {geometry::cosineDirection(normal, s, t), 1.0};
  Turn turn;
  if (s >= share)
    turn.direction = geometry::cosineDirection(normal, (s - share) / (1.0 - share), t);
  else if (!distant.sampleLobe(s / share, t, random.unit(), turn.direction))
    return turn;
  const double cosine = std::max(dot(normal, turn.direction), 0.0) / det::kPi;
  turn.weight = cosine / ((1.0 - share) * cosine + share * distant.lobeDensity(turn.direction));
  return turn;
}

/// Irradiance of a surface by the sun and the moon.
Number3 lightsAt(const PathScene& scene, const Number3& origin, const Number3& normal) {
  Number3 sum(0.0);
  for (const DirectionalLight& light : scene.distant.lights()) {
    const double cosine = dot(normal, light.direction);
    if (cosine > 0.0)
      sum += light.irradiance * geometry::arrivingShare(scene.tracer, origin, light.direction, kFar) * cosine;
  }
  return sum;
}

/// Irradiance of a surface by the level's own lights.
Number3 ownLightsAt(const geometry::Tracer& tracer, const Number3& origin, const Number3& normal) {
  Number3 sum(0.0);
  for (const geometry::StaticLight& light : tracer.surfaces().light) {
    const geometry::LightArriving from = geometry::arrivingAt(light, origin, normal);
    if (from.irradiance != Number3(0.0))
      sum += from.irradiance * geometry::arrivingShare(tracer, origin, from.direction, from.distance);
  }
  return sum;
}

}  // namespace

Number3 localIrradiance(const geometry::Tracer& tracer, const LocalLight& light, const Number3& origin,
                        const Number3& normal, double s, double t) {
  const Number3 to_light = light.position - origin;
  const double squared = dot(to_light, to_light);
  if (squared == 0.0 && light.radius_m == 0.0) return Number3(0.0);
  const double radius2 = light.radius_m * light.radius_m;
  const bool inside = squared <= radius2;
  // From outside, directions are uniform over the cone that the sphere fills; from inside, the sphere is everywhere.
  const double widest2 = inside ? 1.0 : radius2 / squared;
  const double narrowest = std::sqrt(1.0 - widest2);
  const double cosine_axis = 1.0 - s * widest2 / (1.0 + narrowest);
  const Number3 direction = inside ? geometry::cosineDirection(normal, s, t)
                                   : geometry::cosineDirection(to_light / std::sqrt(squared),
                                                               std::max(1.0 - cosine_axis * cosine_axis, 0.0), t);
  const double cosine = dot(normal, direction);
  if (cosine <= 0.0) return Number3(0.0);
  const double along = dot(to_light, direction);
  const double half_chord = std::sqrt(std::max(radius2 - squared + along * along, 0.0));
  const Number3 share =
      geometry::arrivingShare(tracer, origin, direction, inside ? along + half_chord : along - half_chord);
  return share *
         (inside ? light.intensity / radius2 : light.intensity * (2.0 * cosine / (squared * (1.0 + narrowest))));
}

LightShares tracePath(const PathScene& scene, const geometry::Hit& start, double s, double t,
                      geometry::Random& random) {
  const geometry::Tracer& tracer = scene.tracer;
  const DistantLight& distant = scene.distant;
  LightShares found;
  geometry::Hit at = start;
  Turn turn = turnAt(distant, at.normal, s, t, random);
  Number3 throughput(det::kPi);  // turns cosine-distributed radiance into irradiance
  for (int bounced = 0;; ++bounced) {
    throughput *= turn.weight;
    if (throughput == Number3(0.0)) return found;
    const geometry::Sight sight =
        geometry::lookAlong(tracer, tracer.leaving(at), turn.direction, true, [&] { return random.unit(); });
    found.local += throughput * sight.emission;
    throughput = throughput * sight.weight;
    if (!sight.hit) {
      if (turn.direction.y >= 0.0) {
        found.sky += throughput * distant.skyRadiance(turn.direction);
      } else if (bounced < scene.bounces) {
        found.sky += throughput * distant.groundUnderSky();
        found.sun_bounce += throughput * distant.groundUnderLights();
        found.local += throughput * scene.ground_under_own_lights;
      }
      return found;
    }
    at = *sight.hit;
    if (bounced == scene.bounces) return found;
    throughput = throughput * tracer.albedo(at);
    if (throughput == Number3(0.0)) return found;
    const Number3 origin = tracer.leaving(at);
    found.sun_bounce += throughput * lightsAt(scene, origin, at.normal) / det::kPi;
    found.local += throughput * ownLightsAt(tracer, origin, at.normal) / det::kPi;
    for (const LocalLight& light : scene.lights) {
      const double u = random.unit();
      const double v = random.unit();
      found.local += throughput * localIrradiance(tracer, light, origin, at.normal, u, v) / det::kPi;
    }
    const double u = random.unit();
    const double v = random.unit();
    turn = turnAt(distant, at.normal, u, v, random);
  }
}

PathScene pathScene(const geometry::Tracer& tracer, const DistantLight& distant, std::span<const LocalLight> lights,
                    int bounces) {
  return {tracer, distant, lights, bounces,
          distant.groundAlbedo() * geometry::onOpenGround(tracer.surfaces().light) / det::kPi};
}

LightShares meanOfBatch(const PathScene& scene, const geometry::Hit& start, std::size_t strata, std::uint64_t seed,
                        std::size_t batch) {
  LightShares sum;
  for (std::size_t i = 0; i < strata * strata; ++i) {
    geometry::Random random(seed, batch, i);
    const double s = (static_cast<double>(i % strata) + random.unit()) / static_cast<double>(strata);
    const double t = (static_cast<double>(i / strata) + random.unit()) / static_cast<double>(strata);
    const LightShares found = tracePath(scene, start, s, t, random);
    sum.sky += found.sky;
    sum.sun_bounce += found.sun_bounce;
    sum.local += found.local;
  }
  const double share = 1.0 / static_cast<double>(strata * strata);
  return {sum.sky * share, sum.sun_bounce * share, sum.local * share};
}

Number3 directIrradiance(const PathScene& scene, const geometry::Hit& at) {
  const Number3 origin = scene.tracer.leaving(at);
  Number3 sum = lightsAt(scene, origin, at.normal) + ownLightsAt(scene.tracer, origin, at.normal);
  for (const LocalLight& light : scene.lights)
    sum += localIrradiance(scene.tracer, {light.position, light.intensity, 0.0}, origin, at.normal, 0.5, 0.5);
  return sum;
}

}  // namespace welkin::reference
