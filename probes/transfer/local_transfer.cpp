// SPDX-License-Identifier: Apache-2.0
#include "probes/transfer/local_transfer.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "probes/geometry/random.h"
#include "probes/transfer/local_lights.h"
#include "probes/transfer/rounds.h"
#include "probes/transfer/sums.h"
#include "probes/transfer/trace_transfer.h"
#include "sh/deterministic.h"
#include "sky/base/error.h"

namespace welkin::transfer {
namespace {

constexpr std::uint64_t kLocal = 0x6c6f63616cU;  ///< separates these paths from those of the distant light
constexpr std::uint32_t kPathsAtOnce = 256;      ///< limits the memory
constexpr std::uint32_t kChoicePaths = 128;  ///< for the choice under a budget; the choice has no error bound to meet
constexpr std::uint32_t kMostChoicePaths = 4096;  ///< for the choice without a budget; their vertices are kept

[[noreturn]] void refuse(const std::string& what) {
  throw base::Error(base::ExitStatus::content, "local transfer: " + what);
}

void check(const LocalSettings& s, const std::vector<Number3>& lights) {
  if (s.rays < kLeastRays || s.rays > kMostRays || s.rays % kReplicates != 0)
    refuse(fmt::format("rays: {}; allowed: multiples of {} from {} to {}", s.rays, kReplicates, kLeastRays, kMostRays));
  if (s.bounces < 1 || s.bounces > kMostBounces)
    refuse(fmt::format("bounces: {}; allowed: 1 to {}", s.bounces, kMostBounces));
  if (!(s.reach_m >= 0.0)) refuse(fmt::format("reach_m: {}; allowed: at least 0", s.reach_m));
  if (s.light_rays == 0) refuse("light rays: 0; allowed: at least 1");
  if (s.lights == 0 || s.lights > kMostLocalLights)
    refuse(fmt::format("lights a probe: {}; allowed: 1 to {}", s.lights, kMostLocalLights));
  if (!(s.nearest_m >= 0.0 && s.nearest_m <= geometry::kSector_m))
    refuse(fmt::format("nearest distance: {} m; allowed: 0 to {}", s.nearest_m, geometry::kSector_m));
  if (!(s.max_error >= 0.0 && s.max_error < 1.0))
    refuse(fmt::format("max-error: {}; allowed: at least 0, less than 1", s.max_error));
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

bool isWithin(const Number3& p, const Number3& about, double reach_m) {
  return std::abs(p.x - about.x) <= reach_m && std::abs(p.z - about.z) <= reach_m;
}

/// Sums over the paths of a replicate, by light.
using ReplicateSums = std::array<std::vector<Radiance>, kReplicates>;

/// Means over replicates, and the spread of coefficient 0.
class ReplicateMeans {
 public:
  /// `paths` is the number of paths per replicate.
  ReplicateMeans(const ReplicateSums& sums, std::uint32_t paths)
      : mean_(sums[0].size()), squares_(sums[0].size(), Number3(0.0)) {
    constexpr double kShare = 1.0 / double{kReplicates};
    const double density = 4.0 * det::kPi / static_cast<double>(paths);
    for (const std::vector<Radiance>& sum : sums)
      for (std::size_t l = 0; l < mean_.size(); ++l) {
        for (std::size_t k = 0; k < 4; ++k) mean_[l][k] += sum[l][k] * density * kShare;
        const Number3 constant = sum[l][0] * density;
        squares_[l] += constant * constant * kShare;
      }
  }

  const Radiance& mean(std::size_t l) const { return mean_[l]; }
  Number3 standardError(std::size_t l) const {
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

/// Stores the transfers by which some light arrived, and their errors.
void setTransfer(const std::vector<std::size_t>& chosen, const ReplicateMeans& means, LocalProbe& probe) {
  probe.transfer.clear();
  probe.standard_error.clear();
  double influence = 0.0;
  double interval = 0.0;
  for (std::size_t l = 0; l < chosen.size(); ++l) {
    const LocalTransfer transfer{static_cast<std::uint32_t>(chosen[l]), means.mean(l)};
    if (transfer.influence() == 0.0) continue;
    const Number3 error = means.standardError(l);
    probe.transfer.push_back(transfer);
    probe.standard_error.push_back(error);
    influence += transfer.influence();
    interval += kStudent * (error.x + error.y + error.z);
  }
  probe.error = influence > 0.0 ? interval / influence : 0.0;
}

}  // namespace

LocalTransferTracer::LocalTransferTracer(const geometry::Tracer& tracer, const LocalSettings& settings,
                                         std::vector<Number3> lights)
    : tracer_(&tracer), settings_(settings), light_(std::move(lights)) {
  check(settings_, light_);
}

LocalProbe LocalTransferTracer::trace(const Number3& position, geometry::SectorId sector, std::size_t probe,
                                      const base::Progress& progress) const {
  const geometry::Tracer seen = tracer_->within(position, settings_.reach_m);
  const auto most = static_cast<std::uint32_t>(settings_.rays / kReplicates);
  const auto points_of = [&](std::size_t replicate) {
    return PathPoints(circle_, geometry::Random(sector.x, sector.z, probe, replicate, kLocal).next(),
                      settings_.bounces);
  };
  LocalProbe result;
  std::uint64_t told = 0;
  const auto tell = [&] {
    progress.step(result.rays - told);
    told = result.rays;
  };
  std::vector<std::size_t> chosen;
  std::vector<Number3> light;
  const auto choose = [&](std::size_t l) {
    chosen.push_back(l);
    light.push_back(light_[l]);
  };
  for (std::size_t l = 0; l < light_.size(); ++l)
    if (isWithin(light_[l], position, settings_.reach_m)) choose(l);
  std::vector<PathVertex> vertices;
  if (light.size() > settings_.lights) {
    // The choice uses separate paths. It knows nothing of the later measurement, which keeps that unbiased.
    const std::uint32_t paths = std::min(most, settings_.max_error > 0.0 ? kChoicePaths : kMostChoicePaths);
    result.rays += traceVertices(seen, position, points_of(kReplicates), 0, paths, settings_.bounces, vertices);
    const auto influence =
        influenceOf(seen, position, vertices, light, settings_.light_rays, settings_.nearest_m, result.rays);
    const std::vector<std::size_t> within = std::exchange(chosen, {});
    light.clear();
    for (const std::size_t i : mostInfluential(influence, settings_.lights)) choose(within[i]);
    tell();
  }
  if (chosen.empty()) return result;
  LightDraw draw(light, settings_.light_rays, settings_.nearest_m);
  std::vector<PathPoints> points;
  for (std::size_t r = 0; r < kReplicates; ++r) points.push_back(points_of(r));
  ReplicateSums sums;
  sums.fill(std::vector<Radiance>(light.size()));
  const auto addPaths = [&](std::size_t r, std::uint32_t from, std::uint32_t to) {
    vertices.clear();
    result.rays += traceVertices(seen, position, points[r], from, to, settings_.bounces, vertices);
    for (const PathVertex& vertex : vertices)
      draw.at(vertex, [&](std::size_t l, double irradiance) {
        ++result.rays;
        const Number3 share = shareBetween(seen, vertex.origin, light[l]);
        if (share != Number3(0.0)) addRadiance(sums[r][l], vertex.first, vertex.reflected * share * irradiance);
      });
    tell();
  };
  const auto paths = traceRounds(most, settings_.max_error, [&](std::uint32_t from, std::uint32_t to) {
    for (std::size_t r = 0; r < kReplicates; ++r)
      for (std::uint32_t i = from; i < to; i += kPathsAtOnce) addPaths(r, i, std::min(i + kPathsAtOnce, to));
    setTransfer(chosen, ReplicateMeans(sums, to), result);
    return result.error;
  });
  result.paths = paths * kReplicates;
  return result;
}

std::vector<LocalProbe> LocalTransferTracer::trace(const geometry::PlacedSector& sector) const {
  std::vector<LocalProbe> traced(sector.probe.size());
  tbb::parallel_for(std::size_t{0}, traced.size(),
                    [&](std::size_t i) { traced[i] = trace(sector.probe[i].position, sector.id, i); });
  return traced;
}

}  // namespace welkin::transfer
