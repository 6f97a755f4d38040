// SPDX-License-Identifier: Apache-2.0
// Traces paths from a point to the distant light.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "probes/geometry/random.h"
#include "probes/geometry/see_through.h"
#include "probes/transfer/path_points.h"
#include "probes/transfer/proportional_draw.h"
#include "probes/transfer/trace_transfer.h"
#include "sh/deterministic.h"

namespace welkin::transfer {

using f64::Number3;

/// The light of the level itself that a point may see.
struct OwnLight {
  bool emissive = false;                     ///< some surface emits
  std::vector<geometry::StaticLight> light;  ///< within the point's reach
  Number3 plane_radiance{0.0};               ///< of the ground beyond the level, under the directional ones
};

/// Traces paths one by one. `Rays` is Tracer or a class with its interface, such as a benchmark's recorder. `Sink`
/// takes what a path finds, and where; throughput is the product of the albedos on the way, in [0, 1]:
/// - open(direction, share): the sky in the path's first direction, past glass that passes this share
/// - openPlane(share): the ground beyond the level in the first direction
/// - sky(direction, throughput), plane(throughput): the same after a bounce
/// - emitted(radiance): light of the level's own
/// - light(index, radiance): light that a surface reflects, of a TransferSettings::light_directions of normal
///   irradiance 1
template <typename Rays, typename Sink>
class Paths {
 public:
  Paths(const Rays& rays, const TransferSettings& settings, const OwnLight& own, Sink& sink)
      : rays_(rays),
        settings_(settings),
        own_(own),
        sink_(sink),
        arriving_(own.light.size()),
        amount_(own.light.size()) {}

  /// Traces path i from `origin` in its first direction. Its bounces take the points of `first_bounce` and following.
  void trace(const Number3& origin, const Number3& first, const PathPoints& points, std::uint32_t i,
             int first_bounce = 0) {
    ++ray_count_;
    geometry::Random random = points.choicesOf(i);
    const geometry::Sight sight = look(origin, first, random);
    if (own_.emissive) sink_.emitted(sight.emission);
    if (sight.hit)
      follow(*sight.hit, sight.weight, points, i, first_bounce, random);
    else if (first.y > 0.0)
      sink_.open(first, sight.weight);
    else if (settings_.bounces > 0)
      sink_.openPlane(sight.weight);
  }

  std::uint64_t rayCount() const { return ray_count_; }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();

  geometry::Sight look(const Number3& origin, const Number3& direction, geometry::Random& random) const {
    return geometry::lookAlong(rays_, origin, direction, own_.emissive, [&] { return random.unit(); });
  }

  /// Follows a path from its first surface on.
  void follow(geometry::Hit hit, Number3 throughput, const PathPoints& points, std::uint32_t i, int first_bounce,
              geometry::Random& random) {
    for (int bounce = 0; bounce < settings_.bounces; ++bounce) {
      const int stream = first_bounce + bounce;
      throughput = throughput * rays_.albedo(hit);
      if (throughput == Number3(0.0)) return;
      const Number3 origin = rays_.leaving(hit);
      addLights(hit.normal, origin, throughput, points.lightOffset(stream, i));
      addOwnLights(hit.normal, origin, throughput, points.lightOffset(stream, i));
      const Number3 next = points.aboutNormal(stream, i, hit.normal);
      ++ray_count_;
      const bool last = bounce + 1 == settings_.bounces;
      if (last && !own_.emissive) {  // only the light that leaves the level matters
        if (next.y <= 0.0) return;
        const Number3 share = geometry::arrivingShare(rays_, origin, next, kFar);
        if (share != Number3(0.0)) sink_.sky(next, throughput * share);
        return;
      }
      const geometry::Sight sight = look(origin, next, random);
      if (own_.emissive) sink_.emitted(throughput * sight.emission);
      throughput = throughput * sight.weight;
      if (!sight.hit) {
        if (next.y > 0.0)
          sink_.sky(next, throughput);
        else if (!last)
          sink_.plane(throughput);
        return;
      }
      hit = *sight.hit;
    }
  }

  /// Systematic sampling: tests light_rays of the directions, evenly spread from a random one. Each test counts for all
  /// the directions that it represents. Lights behind the surface or below the horizon cost no ray.
  void addLights(const Number3& normal, const Number3& origin, const Number3& throughput, double offset) {
    const std::size_t lights = settings_.light_directions.size();
    if (lights == 0) return;
    const std::size_t tested = std::min(settings_.light_rays, lights);
    const double step = static_cast<double>(lights) / static_cast<double>(tested);
    for (std::size_t j = 0; j < tested; ++j) {
      const std::size_t index =
          std::min(static_cast<std::size_t>((static_cast<double>(j) + offset) * step), lights - 1);
      const Number3& light = settings_.light_directions[index];
      const double cosine = dot(normal, light);
      if (cosine <= 0.0 || light.y <= 0.0) continue;
      ++ray_count_;
      const Number3 share = geometry::arrivingShare(rays_, origin, light, kFar);
      if (share == Number3(0.0)) continue;
      sink_.light(index, throughput * share * (cosine * step / det::kPi));
    }
  }

  /// Tests at most light_rays of the level's own lights, drawn in proportion to their unshadowed light. They shine at
  /// every hour, so their light counts as emitted.
  void addOwnLights(const Number3& normal, const Number3& origin, const Number3& throughput, double offset) {
    if (amount_.empty()) return;
    for (std::size_t l = 0; l < amount_.size(); ++l) {
      arriving_[l] = geometry::arrivingAt(own_.light[l], origin, normal);
      const Number3& e = arriving_[l].irradiance;
      amount_[l] = e.x + e.y + e.z;
    }
    drawInProportion(amount_, settings_.light_rays, offset, [&](std::size_t l, double represented) {
      const geometry::LightArriving& from = arriving_[l];
      ++ray_count_;
      const Number3 share = geometry::arrivingShare(rays_, origin, from.direction, from.distance);
      if (share == Number3(0.0)) return;
      sink_.emitted(throughput * share * from.irradiance * (represented / (amount_[l] * det::kPi)));
    });
  }

  const Rays& rays_;
  const TransferSettings& settings_;
  const OwnLight& own_;
  Sink& sink_;
  std::vector<geometry::LightArriving> arriving_;
  std::vector<double> amount_;
  std::uint64_t ray_count_ = 0;
};

/// Whether any surface emits.
inline bool anyEmissive(const geometry::Surfaces& surfaces) {
  return std::any_of(surfaces.material.begin(), surfaces.material.end(),
                     [](const geometry::Material& m) { return !(m.emission == Number3(0.0)); });
}

/// The level's own light within reach of a position. `emissive` as anyEmissive.
OwnLight ownLightAt(const geometry::Tracer& tracer, const TransferSettings& settings, bool emissive,
                    const Number3& position);

}  // namespace welkin::transfer
