// SPDX-License-Identifier: Apache-2.0
// Traces the paths of one probe to the distant light.
#pragma once

#include <algorithm>
#include <cmath>

#include "probes/geometry/sector.h"
#include "probes/transfer/paths.h"
#include "probes/transfer/rounds.h"
#include "probes/transfer/sums.h"

namespace welkin::transfer {

using f64::Number3;

/// Adds paths to the sums of a replicate, weighted for each direction of the transfer basis.
class ProbeSink {
 public:
  /// Starts a path of the replicate.
  void begin(const Number3& first, std::array<HalfSums, 2>& sums) {
    half_ = &sums[static_cast<std::size_t>(first.y > 0.0 ? Half::above : Half::below)];
    for (std::size_t b = 0; b < kDirections; ++b) {
      weight_[b] = std::max(dot(first, basis_[b]), 0.0);
      half_->weight[b] += weight_[b];
    }
  }

  /// Visibility has no colour: it takes what all channels have, and the sky's transfer takes the rest.
  void open(const Number3& direction, const Number3& share) {
    const double grey = std::min({share.x, share.y, share.z});
    for (std::size_t b = 0; b < kDirections; ++b) half_->open[b] += weight_[b] * grey;
    if (share != Number3(grey)) sky(direction, share - Number3(grey));
  }

  void sky(const Number3& direction, const Number3& throughput) {
    addWeighted(half_->sky[0], weight_, throughput * det::kShConstant);
    addWeighted(half_->sky[1], weight_, throughput * (det::kShLinear * direction.y));
    addWeighted(half_->sky[2], weight_, throughput * (det::kShLinear * direction.z));
    addWeighted(half_->sky[3], weight_, throughput * (det::kShLinear * direction.x));
  }

  void openPlane(const Number3& share) { plane(share); }
  void plane(const Number3& throughput) { addWeighted(half_->plane, weight_, throughput); }
  void emitted(const Number3& radiance) { addWeighted(half_->emitted, weight_, radiance); }
  void light(std::size_t index, const Number3& radiance) { addWeighted(half_->light[index], weight_, radiance); }

 private:
  std::array<Number3, kDirections> basis_ = transferBasis();
  DirectionWeights weight_{};
  HalfSums* half_ = nullptr;
};

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
  ProbeSink sink;
  Paths<Rays, ProbeSink> paths(rays, settings, own, sink);
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
        for (std::uint32_t k = i; k < end; ++k) {
          const Number3 first = points[r].onSphere(k);
          sink.begin(first, sums[r]);
          paths.trace(position, first, points[r], k);
        }
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
