// SPDX-License-Identifier: Apache-2.0
// Traces the paths of one probe to the distant light.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "probes/geometry/random.h"
#include "probes/geometry/sector.h"
#include "probes/transfer/path_points.h"
#include "probes/transfer/rounds.h"
#include "probes/transfer/sums.h"
#include "probes/transfer/trace_transfer.h"
#include "sh/deterministic.h"

namespace welkin::transfer {

using f64::Number3;

/// Traces paths from a position. `Rays` is Tracer or a class with its interface, such as a benchmark's recorder.
template <typename Rays>
class Paths {
 public:
  Paths(const Rays& rays, const TransferSettings& settings, bool emissive)
      : rays_(rays), settings_(settings), emissive_(emissive) {}

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
      const auto hit = rays_.closest(position, first, kFar);
      if (hit)
        follow(*hit, points, i, half);
      else if (first.y > 0.0)
        for (std::size_t b = 0; b < kDirections; ++b) half.open[b] += weight_[b];
      else if (settings_.bounces > 0)
        addWeighted(half.plane, weight_, Number3(1.0));
    }
  }

  std::uint64_t rayCount() const { return ray_count_; }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();

  /// Follows a path from its first surface on.
  void follow(geometry::Hit hit, const PathPoints& points, std::uint32_t i, HalfSums& half) {
    Number3 throughput(1.0);
    for (int bounce = 0;; ++bounce) {
      if (emissive_) addWeighted(half.emitted, weight_, throughput * rays_.emission(hit));
      if (bounce == settings_.bounces) return;
      throughput = throughput * rays_.albedo(hit);
      if (throughput == Number3(0.0)) return;
      const Number3 origin = rays_.leaving(hit);
      addLights(hit.normal, origin, throughput, points.lightOffset(bounce, i), half);
      const Number3 next = points.aboutNormal(bounce, i, hit.normal);
      ++ray_count_;
      const bool last = bounce + 1 == settings_.bounces;
      if (last && !emissive_) {  // only whether the ray leaves the level matters
        if (next.y > 0.0 && !rays_.occluded(origin, next, kFar)) addSky(next, throughput, half);
        return;
      }
      const auto surface = rays_.closest(origin, next, kFar);
      if (!surface) {
        if (next.y > 0.0)
          addSky(next, throughput, half);
        else if (!last)
          addWeighted(half.plane, weight_, throughput);
        return;
      }
      hit = *surface;
    }
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
      if (rays_.occluded(origin, light, kFar)) continue;
      addWeighted(half.light[index], weight_, throughput * (cosine * step / det::kPi));
    }
  }

  const Rays& rays_;
  const TransferSettings& settings_;
  bool emissive_;
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
TracedProbe traceProbe(const Rays& rays, const TransferSettings& settings, const CircleTable& circle, bool emissive,
                       const Number3& position, geometry::SectorId sector, std::size_t probe,
                       const base::Progress& progress = {}) {
  constexpr std::uint32_t kBlock = 1024;  // paths between two calls of progress: some milliseconds
  TransferSums sums;
  std::vector<PathPoints> points;
  for (std::size_t r = 0; r < kReplicates; ++r) {
    for (HalfSums& half : sums[r]) half.light.resize(settings.light_directions.size());
    points.emplace_back(circle, geometry::Random(sector.x, sector.z, probe, r).next(), settings.bounces);
  }
  Paths<Rays> paths(rays, settings, emissive);
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
    result = summedUp(sums, settings.ground_albedo, settings.light_directions);
    return result.effort.error;
  });
  tell();
  result.effort.paths = done * kReplicates;
  result.effort.rays = paths.rayCount();
  return result;
}

}  // namespace welkin::transfer
