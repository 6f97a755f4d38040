// SPDX-License-Identifier: Apache-2.0
#include "probes/transfer/local_transfer.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "probes/random.h"
#include "probes/transfer/local_lights.h"
#include "probes/transfer/sums.h"
#include "probes/transfer/trace_transfer.h"
#include "sh/deterministic.h"
#include "sky/error.h"

namespace welkin::probes {
namespace {

constexpr std::uint64_t kLocal = 0x6c6f63616cU;  ///< keeps these paths apart from those of the distant light
constexpr std::uint32_t kBlock = 256;            ///< paths at once: it bounds the memory

[[noreturn]] void refuse(const std::string& what) {
  throw Error(ExitStatus::content, "local transfer: " + what);
}

void check(const LocalSettings& s, const std::vector<Number3>& lights) {
  if (s.rays < kLeastRays || s.rays > kMostRays || s.rays % kReplicates != 0)
    refuse(fmt::format("rays: {}; allowed: multiples of {} from {} to {}", s.rays, kReplicates, kLeastRays, kMostRays));
  if (s.bounces < 1 || s.bounces > kMostBounces)
    refuse(fmt::format("bounces: {}; allowed: 1 to {}", s.bounces, kMostBounces));
  if (s.light_rays == 0) refuse("light rays: 0; allowed: at least 1");
  if (s.lights == 0 || s.lights > kMostLocalLights)
    refuse(fmt::format("lights a probe: {}; allowed: 1 to {}", s.lights, kMostLocalLights));
  if (!(s.nearest_m >= 0.0 && s.nearest_m <= kSector_m))
    refuse(fmt::format("nearest distance: {} m; allowed: 0 to {}", s.nearest_m, kSector_m));
  for (const Number3& p : lights)
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      refuse(fmt::format("the light at ({}, {}, {}): allowed: finite positions", p.x, p.y, p.z));
}

using Radiance = std::array<Number3, 4>;

void addRadiance(Radiance& sum, const Number3& first, const Number3& radiance) {
  sum[0] += radiance * det::kShConstant;
  sum[1] += radiance * (det::kShLinear * first.y);
  sum[2] += radiance * (det::kShLinear * first.z);
  sum[3] += radiance * (det::kShLinear * first.x);
}

/// Means over replicates, and the spread of coefficient 0.
class ReplicateMeans {
 public:
  explicit ReplicateMeans(std::size_t lights) : mean_(lights), squares_(lights, Number3(0.0)) {}

  void add(const std::vector<Radiance>& replicate) {
    constexpr double kShare = 1.0 / double{kReplicates};
    for (std::size_t l = 0; l < mean_.size(); ++l) {
      for (std::size_t k = 0; k < 4; ++k) mean_[l][k] += replicate[l][k] * kShare;
      squares_[l] += replicate[l][0] * replicate[l][0] * kShare;
    }
  }

  const Radiance& mean(std::size_t l) const { return mean_[l]; }
  Number3 error(std::size_t l) const {
    Number3 result;
    for (int c = 0; c < 3; ++c) {
      const double variance = squares_[l][c] - mean_[l][0][c] * mean_[l][0][c];
      result[c] = std::sqrt(std::max(variance, 0.0) / (double{kReplicates} - 1.0));
    }
    return result;
  }

 private:
  std::vector<Radiance> mean_;
  std::vector<Number3> squares_;
};

}  // namespace

LocalTransferTracer::LocalTransferTracer(const Tracer& tracer, const LocalSettings& settings,
                                         std::vector<Number3> lights)
    : tracer_(&tracer), settings_(settings), light_(std::move(lights)) {
  check(settings_, light_);
}

LocalProbe LocalTransferTracer::trace(const Number3& position, SectorId sector, std::size_t probe) const {
  const auto paths = static_cast<std::uint32_t>(settings_.rays / kReplicates);
  const auto points_of = [&](std::size_t replicate) {
    return PathPoints(circle_, Random(sector.x, sector.z, probe, replicate, kLocal).next(), settings_.bounces);
  };
  LocalProbe result;
  std::vector<std::size_t> chosen(light_.size());
  std::iota(chosen.begin(), chosen.end(), std::size_t{0});
  std::vector<PathVertex> vertices;
  if (light_.size() > settings_.lights) {
    // Paths of their own: the choice knows nothing of what is measured then, which keeps that unbiased.
    result.rays += traceVertices(*tracer_, position, points_of(kReplicates), 0, paths, settings_.bounces, vertices);
    const auto influence =
        influenceOf(*tracer_, position, vertices, light_, settings_.light_rays, settings_.nearest_m, result.rays);
    chosen = mostInfluential(influence, settings_.lights);
  }
  std::vector<Number3> light;
  for (const std::size_t l : chosen) light.push_back(light_[l]);
  LightDraw draw(light, settings_.light_rays, settings_.nearest_m);
  ReplicateMeans means(light.size());
  for (std::size_t r = 0; r < kReplicates && !light.empty(); ++r) {
    const PathPoints points = points_of(r);
    std::vector<Radiance> sum(light.size());
    for (std::uint32_t from = 0; from < paths; from += kBlock) {
      vertices.clear();
      result.rays +=
          traceVertices(*tracer_, position, points, from, std::min(from + kBlock, paths), settings_.bounces, vertices);
      for (const PathVertex& vertex : vertices)
        draw.at(vertex, [&](std::size_t l, double irradiance) {
          ++result.rays;
          if (seesEachOther(*tracer_, vertex.origin, light[l]))
            addRadiance(sum[l], vertex.first, vertex.reflected * irradiance);
        });
    }
    for (Radiance& radiance : sum)
      for (Number3& k : radiance) k *= 4.0 * det::kPi / static_cast<double>(paths);
    means.add(sum);
  }
  for (std::size_t l = 0; l < light.size(); ++l) {
    const LocalTransfer transfer{static_cast<std::uint32_t>(chosen[l]), means.mean(l)};
    if (transfer.influence() == 0.0) continue;
    result.transfer.push_back(transfer);
    result.error.push_back(means.error(l));
  }
  return result;
}

std::vector<LocalProbe> LocalTransferTracer::trace(const PlacedSector& sector) const {
  std::vector<LocalProbe> traced(sector.probe.size());
  tbb::parallel_for(std::size_t{0}, traced.size(),
                    [&](std::size_t i) { traced[i] = trace(sector.probe[i].position, sector.id, i); });
  return traced;
}

}  // namespace welkin::probes
