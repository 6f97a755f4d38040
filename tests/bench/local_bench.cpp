// SPDX-License-Identifier: Apache-2.0
// Local transfer of a sector, with the virtual lights of the eight about it. It measures time, rays and error a probe,
// with a number of paths and under budgets. It rounds the numbers and shows bytes, error and transfers without room.
// Then it compares the light of lamps with the reference, in virtual lights' places and between them.
//   local_bench [PATHS [LIGHTS A VERTEX [NEAREST_M [OBJ SCALE X Z]]]]      PATHS of a probe and of the reference
#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "probes/build/local_bake.h"
#include "probes/geometry/random.h"
#include "probes/loader/read_scene.h"
#include "probes/loader/surfaces_of.h"
#include "probes/placement/placement.h"
#include "probes/reference/reference.h"
#include "probes/transfer/fixed_point.h"
#include "probes/transfer/local_encoding.h"
#include "probes/transfer/local_paths.h"
#include "probes/transfer/local_relight.h"
#include "rounding.h"
#include "town.h"

namespace {

using namespace welkin;

geometry::Surfaces levelOf(int argc, char** argv) {
  if (argc < 8) return bench::town();
  const double scale = std::atof(argv[5]);
  level::LevelFile level;
  level.geometry.emplace_back();
  level.geometry[0].path = argv[4];
  level.geometry[0].transform = {{scale, 0, 0}, {0, scale, 0}, {0, 0, scale}, {}};
  return loader::surfacesOf(loader::readScene(level), 1.0);
}

reference::DistantLight darkness() {
  static model::Sky sky;
  sky.luminance = *model::findLuminance("cie-5");
  sky.normalise_to_sun = false;
  sky.intensity = base::Curve::constant(0.0);
  sky.sun.path.key_time_h = {0.0};
  sky.sun.path.key_azimuth_rad = {0.4};
  sky.sun.path.key_elevation_rad = {0.7};
  return {sky, 12.0};
}

struct LampError {
  double rms = 0.0;   ///< of the difference, over the light's rms
  double mean = 0.0;  ///< of the difference's magnitude, over the light's mean
};

/// Compares the irradiance of lamps at `place` by local transfer with the reference, over all directions of the probes
/// within 12 m of a lamp.
LampError lampError(const geometry::Tracer& tracer, const geometry::PlacedSector& sector,
                    const transfer::SectorLocal& local, const std::vector<f64::Number3>& place, std::size_t paths) {
  const reference::DistantLight dark = darkness();
  const auto see = [&](const f64::Number3& a, const f64::Number3& b) { return transfer::seesEachOther(tracer, a, b); };
  double difference = 0.0;
  double light = 0.0;
  double magnitude = 0.0;
  double sum = 0.0;
  for (const f64::Number3& at : place) {
    const auto shared =
        transfer::relightLocal(local.light, std::vector<transfer::DynamicLight>{{at, f64::Number3(1.0)}}, see);
    const reference::LocalLight lamp[] = {{at, f64::Number3(1.0)}};
    for (std::size_t i = 0; i < sector.probe.size(); ++i) {
      const f64::Number3 away = sector.probe[i].position - at;
      if (dot(away, away) > 144.0) continue;
      const auto irradiance = transfer::relitLocal(local.probe[i], shared.colour);
      for (std::size_t b = 0; b < transfer::kDirections; ++b) {
        const f64::Number3 truth = reference::traceReference(tracer, dark, lamp, sector.probe[i].position,
                                                             transfer::transferBasis()[b], {paths, 2, 1})
                                       .local.value;
        for (int c = 0; c < 3; ++c) {
          difference += (irradiance[b][c] - truth[c]) * (irradiance[b][c] - truth[c]);
          light += truth[c] * truth[c];
          magnitude += std::abs(irradiance[b][c] - truth[c]);
          sum += truth[c];
        }
      }
    }
  }
  return {std::sqrt(difference / light), magnitude / sum};
}

/// Traces the sector on one thread and prints the time, rays and errors.
std::vector<transfer::LocalProbe> traced(const geometry::Tracer& tracer, const geometry::PlacedSector& sector,
                                         const std::vector<f64::Number3>& lights,
                                         const transfer::LocalSettings& settings) {
  const transfer::LocalTransferTracer local(tracer, settings, lights);
  std::vector<transfer::LocalProbe> probes;
  const auto start = std::chrono::steady_clock::now();
  tbb::task_arena(1).execute([&] { probes = local.trace(sector); });
  const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  double paths = 0.0;
  double rays = 0.0;
  double kept = 0.0;
  double sum = 0.0;
  double worst = 0.0;
  std::size_t past = 0;
  for (const transfer::LocalProbe& p : probes) {
    paths += static_cast<double>(p.paths);
    rays += static_cast<double>(p.rays);
    kept += static_cast<double>(p.transfer.size());
    sum += p.error;
    worst = std::max(worst, p.error);
    if (p.error > settings.max_error) ++past;
  }
  const double n = static_cast<double>(probes.size());
  const bool budget = settings.max_error > 0.0;
  fmt::print("{:>6} {:6.0f} {:6.0f}  {:6.1f} {:5.2f}  {:14.2f}  {:9.2f} %, {:9.2f} %  {:>15}\n",
             budget ? fmt::format("{} %", 100.0 * settings.max_error) : "none", paths / n, rays / n, kept / n, ms / n,
             rays / ms / 1e3, 100.0 * sum / n, 100.0 * worst, budget ? fmt::format("{}", past) : "");
  return probes;
}

/// Shares of the influence that find no room in a sector, with so many bytes a transfer: over all probes, and of the
/// worst probe.
std::pair<double, double> lostWith(std::size_t transfer_bytes, std::size_t lights,
                                   const std::vector<transfer::LocalProbe>& probes) {
  std::vector<std::pair<double, std::size_t>> influence;
  std::vector<double> whole(probes.size(), 0.0);
  std::vector<double> lost(probes.size(), 0.0);
  for (std::size_t i = 0; i < probes.size(); ++i)
    for (const transfer::LocalTransfer& t : probes[i].transfer) {
      influence.emplace_back(t.influence(), i);
      whole[i] += t.influence();
    }
  std::sort(influence.rbegin(), influence.rend());
  const std::size_t room =
      (transfer::kMostLocalBytes - probes.size() - transfer::kVirtualLightBytes * lights) / transfer_bytes;
  for (std::size_t i = room; i < influence.size(); ++i) lost[influence[i].second] += influence[i].first;
  double worst = 0.0;
  for (std::size_t i = 0; i < probes.size(); ++i) worst = std::max(worst, lost[i] > 0.0 ? lost[i] / whole[i] : 0.0);
  return {std::accumulate(lost.begin(), lost.end(), 0.0) / std::accumulate(whole.begin(), whole.end(), 0.0), worst};
}

/// Prints the error of fewer bits a coefficient, in a probe's irradiance by one virtual light and by all of them alike.
void printBits(const std::vector<f64::Number3>& lights, const std::vector<transfer::LocalProbe>& probes) {
  fmt::print(
      "bits  bytes a transfer  worst of the largest number  rms of one light, all lights  influence lost: all, worst "
      "probe\n");
  for (const int bits : {16, 12, 8, 6, 4}) {
    double worst = 0.0;
    std::array<double, 2> difference{};
    std::array<double, 2> light{};
    const auto add = [&](std::size_t i, const std::vector<transfer::LocalTransfer>& a,
                         const std::vector<transfer::LocalTransfer>& b) {
      const std::vector<f64::Number3> white(lights.size(), f64::Number3(1.0));
      const auto exact = transfer::relitLocal(a, white);
      const auto coarse = transfer::relitLocal(b, white);
      for (std::size_t d = 0; d < transfer::kDirections; ++d)
        for (int c = 0; c < 3; ++c) {
          light[i] += exact[d][c] * exact[d][c];
          difference[i] += (coarse[d][c] - exact[d][c]) * (coarse[d][c] - exact[d][c]);
        }
    };
    for (const transfer::LocalProbe& p : probes) {
      std::vector<transfer::LocalTransfer> coarse = p.transfer;
      for (std::size_t t = 0; t < coarse.size(); ++t) {
        double largest = 0.0;
        for (const f64::Number3& k : p.transfer[t].radiance)
          largest = std::max({largest, std::abs(k.x), std::abs(k.y), std::abs(k.z)});
        const double scale = transfer::scaleOf(transfer::scaleFor(largest));
        for (std::size_t k = 0; k < 4; ++k)
          for (int c = 0; c < 3; ++c) {
            double& x = coarse[t].radiance[k][c];
            x = bench::rounded(x, scale, bits, true);
            worst = std::max(worst, std::abs(x - p.transfer[t].radiance[k][c]) / largest);
          }
        add(0, {p.transfer[t]}, {coarse[t]});
      }
      add(1, p.transfer, coarse);
    }
    const std::size_t bytes = 4 + static_cast<std::size_t>(12 * bits / 8);
    const auto [lost, worst_probe] = lostWith(bytes, lights.size(), probes);
    fmt::print("{:4}  {:16}  {:25.4f} %  {:15.4f} %, {:8.4f} %  {:12.2f} %, {:10.2f} %\n", bits, bytes, 100.0 * worst,
               100.0 * std::sqrt(difference[0] / light[0]), 100.0 * std::sqrt(difference[1] / light[1]), 100.0 * lost,
               100.0 * worst_probe);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const auto number = [&](int i, int otherwise) { return argc > i ? std::atoi(argv[i]) : otherwise; };
  const geometry::Surfaces surfaces = levelOf(argc, argv);
  const geometry::Tracer tracer(surfaces);
  const geometry::SectorId id{number(6, 0), number(7, 0)};
  std::vector<f64::Number3> lights;
  geometry::PlacedSector sector;
  for (int x = id.x - 1; x <= id.x + 1; ++x)
    for (int z = id.z - 1; z <= id.z + 1; ++z) {
      placement::PlacementReport report;
      const geometry::PlacedSector placed = placement::placeSector(tracer, {x, z}, {}, report);
      for (const geometry::Probe& p : placed.probe) lights.push_back(p.position);
      if (placed.id == id) sector = placed;
    }
  transfer::LocalSettings settings;
  settings.rays = static_cast<std::size_t>(number(1, 1024));
  settings.light_rays = static_cast<std::size_t>(number(2, 8));
  settings.nearest_m = argc > 3 ? std::atof(argv[3]) : build::kNearest_m;
  fmt::print("{} probes, {} virtual lights, {} lights a vertex, {} m\n", sector.probe.size(), lights.size(),
             settings.light_rays, settings.nearest_m);
  fmt::print("budget  paths   rays  lights    ms  million rays/s  error: mean, worst probe  past the budget\n");
  const std::vector<transfer::LocalProbe> probes = traced(tracer, sector, lights, settings);
  for (const double budget : {0.5, 0.2, 0.1, 0.05}) {
    transfer::LocalSettings under = settings;
    under.rays = build::kMostPaths;
    under.max_error = budget;
    traced(tracer, sector, lights, under);
  }
  printBits(lights, probes);
  transfer::LocalThinning thinning;
  const transfer::SectorLocal thinned = transfer::thinnedLocal(lights, probes, transfer::kMostLocalBytes, thinning);
  const transfer::EncodedLocal encoded = transfer::encodeLocal(thinned);
  const transfer::SectorLocal decoded = transfer::decodedLocal(encoded);
  fmt::print("{} bytes; {} transfers kept, {} dropped with {:.4f} % of the influence, at most {:.2f} % of a probe's\n",
             encoded.bytes(), thinning.kept, thinning.dropped, 100.0 * thinning.lost, 100.0 * thinning.worst_probe);
  fmt::print("encoding: {:.1e} of a transfer's largest number\n", transfer::encodingError(thinned, decoded).radiance);
  geometry::Random random(1);
  std::vector<f64::Number3> at;
  std::vector<f64::Number3> between;
  for (int i = 0; i < 40; ++i) {
    const auto probe = static_cast<std::size_t>(random.unit() * static_cast<double>(sector.probe.size()));
    at.push_back(sector.probe[probe].position);
    const double x = random.unit() - 0.5;
    between.push_back(at.back() + f64::Number3(4.0 * x, random.unit(), 4.0 * (random.unit() - 0.5)));
    if (!transfer::seesEachOther(tracer, at.back(), between.back())) between.pop_back();
  }
  for (const auto& [place, name] : {std::pair(&at, "at virtual lights"), std::pair(&between, "between them")}) {
    const LampError error = lampError(tracer, sector, decoded, *place, settings.rays);
    fmt::print("{} lamps {} against the reference: rms {:.1f} %, mean {:.1f} %\n", place->size(), name,
               100.0 * error.rms, 100.0 * error.mean);
  }
  return 0;
}
