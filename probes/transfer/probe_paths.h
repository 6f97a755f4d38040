// SPDX-License-Identifier: Apache-2.0
// Traces the paths of one probe to the distant light.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "probes/geometry/random.h"
#include "probes/geometry/sector.h"
#include "probes/geometry/see_through.h"
#include "probes/transfer/path_points.h"
#include "probes/transfer/proportional_draw.h"
#include "probes/transfer/rounds.h"
#include "probes/transfer/sums.h"
#include "probes/transfer/trace_transfer.h"
#include "sh/deterministic.h"

namespace welkin::transfer {

using f64::Number3;

/// The light of the level itself that a probe may see.
struct OwnLight {
  bool emissive = false;                     ///< some surface emits
  std::vector<geometry::StaticLight> light;  ///< within the probe's reach
  Number3 plane_radiance{0.0};               ///< of the ground beyond the level, under the directional ones
};

/// Traces paths from a position. `Rays` is Tracer or a class with its interface, such as a benchmark's recorder.
template <typename Rays>
class Paths {
 public:
  Paths(const Rays& rays, const TransferSettings& settings, const OwnLight& own)
      : rays_(rays), settings_(settings), own_(own), arriving_(own.light.size()), amount_(own.light.size()) {}

  /// Adds the paths from <= i < to of a replicate.
  void trace(const Number3& position, const PathPoints& points, std::uint32_t from, std::uint32_t to,
             std::array<HalfSums, 2>& sums) {
    for (std::uint32_t i = from; i < to; ++i) {
      const Number3 first = points.onSphere(i);
      HalfSums& half = sums[static_cast<std::size_t>(first.y > 0.0 ? Half::above : Half::below)];
      for (std::size_t b = 0; b < kDirections; ++b) {
        weight_[b] = std::max(dot(first, basis_[b]), 0.0);
        half.weight[b] += weight_[b];
      }
      ++ray_count_;
      geometry::Random random = points.choicesOf(i);
      const geometry::Sight sight = look(position, first, random);
      if (own_.emissive) addWeighted(half.emitted, weight_, sight.emission);
      if (sight.hit)
        follow(*sight.hit, sight.weight, points, i, random, half);
      else if (first.y > 0.0)
        addOpen(first, sight.weight, half);
      else if (settings_.bounces > 0)
        addWeighted(half.plane, weight_, sight.weight);
    }
  }

  std::uint64_t rayCount() const { return ray_count_; }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();

  geometry::Sight look(const Number3& origin, const Number3& direction, geometry::Random& random) const {
    return geometry::lookAlong(rays_, origin, direction, own_.emissive, [&] { return random.unit(); });
  }

  /// Follows a path from its first surface on.
  void follow(geometry::Hit hit, Number3 throughput, const PathPoints& points, std::uint32_t i,
              geometry::Random& random, HalfSums& half) {
    for (int bounce = 0; bounce < settings_.bounces; ++bounce) {
      throughput = throughput * rays_.albedo(hit);
      if (throughput == Number3(0.0)) return;
      const Number3 origin = rays_.leaving(hit);
      addLights(hit.normal, origin, throughput, points.lightOffset(bounce, i), half);
      addOwnLights(hit.normal, origin, throughput, points.lightOffset(bounce, i), half);
      const Number3 next = points.aboutNormal(bounce, i, hit.normal);
      ++ray_count_;
      const bool last = bounce + 1 == settings_.bounces;
      if (last && !own_.emissive) {  // only the light that leaves the level matters
        if (next.y <= 0.0) return;
        const Number3 share = geometry::arrivingShare(rays_, origin, next, kFar);
        if (share != Number3(0.0)) addSky(next, throughput * share, half);
        return;
      }
      const geometry::Sight sight = look(origin, next, random);
      if (own_.emissive) addWeighted(half.emitted, weight_, throughput * sight.emission);
      throughput = throughput * sight.weight;
      if (!sight.hit) {
        if (next.y > 0.0)
          addSky(next, throughput, half);
        else if (!last)
          addWeighted(half.plane, weight_, throughput);
        return;
      }
      hit = *sight.hit;
    }
  }

  /// The sky that a path's first ray sees through surfaces of this share. Visibility has no colour: it takes what all
  /// channels have, and the sky's transfer takes the rest.
  void addOpen(const Number3& direction, const Number3& share, HalfSums& half) {
    const double grey = std::min({share.x, share.y, share.z});
    for (std::size_t b = 0; b < kDirections; ++b) half.open[b] += weight_[b] * grey;
    if (share != Number3(grey)) addSky(direction, share - Number3(grey), half);
  }

  void addSky(const Number3& direction, const Number3& throughput, HalfSums& half) {
    addWeighted(half.sky[0], weight_, throughput * det::kShConstant);
    addWeighted(half.sky[1], weight_, throughput * (det::kShLinear * direction.y));
    addWeighted(half.sky[2], weight_, throughput * (det::kShLinear * direction.z));
    addWeighted(half.sky[3], weight_, throughput * (det::kShLinear * direction.x));
  }

  /// Systematic sampling: tests light_rays of the directions, evenly spread from a random one. Each test counts for all
  /// the directions that it represents. Lights behind the surface or below the horizon cost no ray.
  void addLights(const Number3& normal, const Number3& origin, const Number3& throughput, double offset,
                 HalfSums& half) {
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
      addWeighted(half.light[index], weight_, throughput * share * (cosine * step / det::kPi));
    }
  }

  /// Tests at most light_rays of the level's own lights, drawn in proportion to their unshadowed light. They shine at
  /// every hour, so their light counts as emitted.
  void addOwnLights(const Number3& normal, const Number3& origin, const Number3& throughput, double offset,
                    HalfSums& half) {
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
      addWeighted(half.emitted, weight_,
                  throughput * share * from.irradiance * (represented / (amount_[l] * det::kPi)));
    });
  }

  const Rays& rays_;
  const TransferSettings& settings_;
  const OwnLight& own_;
  std::vector<geometry::LightArriving> arriving_;
  std::vector<double> amount_;
  std::array<Number3, kDirections> basis_ = transferBasis();
  DirectionWeights weight_{};
  std::uint64_t ray_count_ = 0;
};

/// Whether any surface emits.
inline bool anyEmissive(const geometry::Surfaces& surfaces) {
  return std::any_of(surfaces.material.begin(), surfaces.material.end(),
                     [](const geometry::Material& m) { return !(m.emission == Number3(0.0)); });
}

/// Traces paths of a probe until there are enough of them: all at once, or doubled until the error is small.
template <typename Rays>
TracedProbe traceProbe(const Rays& rays, const TransferSettings& settings, const CircleTable& circle,
                       const OwnLight& own, const Number3& position, geometry::SectorId sector, std::size_t probe,
                       const base::Progress& progress = {}) {
  constexpr std::uint32_t kBlock = 1024;  // paths between two calls of progress: some milliseconds
  TransferSums sums;
  std::vector<PathPoints> points;
  for (std::size_t r = 0; r < kReplicates; ++r) {
    for (HalfSums& half : sums[r]) half.light.resize(settings.light_directions.size());
    points.emplace_back(circle, geometry::Random(sector.x, sector.z, probe, r).next(), settings.bounces);
  }
  Paths<Rays> paths(rays, settings, own);
  std::uint32_t untold = 0;
  std::uint64_t told = 0;
  const auto tell = [&] {
    if (untold > 0) progress.step(paths.rayCount() - told);
    untold = 0;
    told = paths.rayCount();
  };
  const auto tracePaths = [&](std::uint32_t from, std::uint32_t to) {
    for (std::size_t r = 0; r < kReplicates; ++r)
      for (std::uint32_t i = from; i < to; i += kBlock) {
        const std::uint32_t end = std::min(i + kBlock, to);
        paths.trace(position, points[r], i, end, sums[r]);
        untold += end - i;
        if (untold >= kBlock) tell();
      }
  };
  const auto most = static_cast<std::uint32_t>(settings.rays / kReplicates);
  TracedProbe result;
  const auto done = traceRounds(most, settings.max_error, [&](std::uint32_t from, std::uint32_t to) {
    tracePaths(from, to);
    result = summedUp(sums, settings.ground_albedo, settings.light_directions, own.plane_radiance);
    return result.effort.error;
  });
  tell();
  result.effort.paths = done * kReplicates;
  result.effort.rays = paths.rayCount();
  return result;
}

}  // namespace welkin::transfer
