// SPDX-License-Identifier: Apache-2.0
// Local transfer of a sector, with the virtual lights of the eight about it: time and rays a probe, standard error,
// bytes, and how far from the reference the light of lamps is that shine from virtual lights' places and between them.
//   local_bench [PATHS [LIGHTS A VERTEX [NEAREST_M [OBJ SCALE X Z]]]]
#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>

#include "probes/level/surfaces_of.h"
#include "probes/placement/placement.h"
#include "probes/random.h"
#include "probes/reference/reference.h"
#include "probes/transfer/local_encoding.h"
#include "probes/transfer/local_paths.h"
#include "probes/transfer/local_relight.h"
#include "town.h"

namespace {

using namespace welkin;
using namespace welkin::probes;

Surfaces levelOf(int argc, char** argv) {
  if (argc < 8) return bench::town();
  const double scale = std::atof(argv[5]);
  LevelFile level;
  level.geometry.emplace_back();
  level.geometry[0].path = argv[4];
  level.geometry[0].transform = {{scale, 0, 0}, {0, scale, 0}, {0, 0, scale}, {}};
  return readSurfaces(level);
}

DistantLight darkness() {
  static sky::Sky sky;
  sky.luminance = *sky::findLuminance("cie-5");
  sky.normalise_to_sun = false;
  sky.intensity = sky::Curve::constant(0.0);
  sky.sun.path.key_time_h = {0.0};
  sky.sun.path.key_azimuth_rad = {0.4};
  sky.sun.path.key_elevation_rad = {0.7};
  return {sky, 12.0};
}

struct LampError {
  double rms = 0.0;   ///< of the difference, over that of the light
  double mean = 0.0;  ///< of its magnitude, over that of the light
};

/// Irradiance of lamps at `place` from the local transfer against the reference, over all directions of the probes
/// within 12 m of them.
LampError lampError(const Tracer& tracer, const PlacedSector& sector, const SectorLocal& local,
                    const std::vector<Number3>& place) {
  const DistantLight dark = darkness();
  const auto see = [&](const Number3& a, const Number3& b) { return seesEachOther(tracer, a, b); };
  double difference = 0.0;
  double light = 0.0;
  double magnitude = 0.0;
  double sum = 0.0;
  for (const Number3& at : place) {
    const auto shared = relightLocal(local.light, std::vector<PointLight>{{at, Number3(1.0)}}, see);
    const LocalLight lamp[] = {{at, Number3(1.0)}};
    for (std::size_t i = 0; i < sector.probe.size(); ++i) {
      const Number3 away = sector.probe[i].position - at;
      if (dot(away, away) > 144.0) continue;
      const auto irradiance = relitLocal(local.probe[i], shared.colour);
      for (std::size_t b = 0; b < kDirections; ++b) {
        const Number3 truth =
            traceReference(tracer, dark, lamp, sector.probe[i].position, transferBasis()[b], {1024, 2, 1}).local.value;
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

}  // namespace

int main(int argc, char** argv) {
  const auto number = [&](int i, int otherwise) { return argc > i ? std::atoi(argv[i]) : otherwise; };
  const Surfaces surfaces = levelOf(argc, argv);
  const Tracer tracer(surfaces);
  const SectorId id{number(6, 0), number(7, 0)};
  std::vector<Number3> lights;
  PlacedSector sector;
  for (int x = id.x - 1; x <= id.x + 1; ++x)
    for (int z = id.z - 1; z <= id.z + 1; ++z) {
      PlacementReport report;
      const PlacedSector placed = placeSector(tracer, {x, z}, {}, report);
      for (const Probe& p : placed.probe) lights.push_back(p.position);
      if (placed.id == id) sector = placed;
    }
  LocalSettings settings;
  settings.rays = static_cast<std::size_t>(number(1, 1024));
  settings.light_rays = static_cast<std::size_t>(number(2, 8));
  if (argc > 3) settings.nearest_m = std::atof(argv[3]);
  const LocalTransferTracer local(tracer, settings, lights);
  std::vector<LocalProbe> probes;
  const auto start = std::chrono::steady_clock::now();
  tbb::task_arena(1).execute([&] { probes = local.trace(sector); });
  const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  const double n = static_cast<double>(probes.size());
  double rays = 0.0;
  double kept = 0.0;
  double influence = 0.0;
  double weighted = 0.0;
  for (const LocalProbe& p : probes) {
    rays += static_cast<double>(p.rays);
    kept += static_cast<double>(p.transfer.size());
    for (std::size_t i = 0; i < p.transfer.size(); ++i) {
      influence += p.transfer[i].influence();
      weighted += p.error[i].x + p.error[i].y + p.error[i].z;
    }
  }
  fmt::print("{} probes, {} virtual lights, {} paths, {} lights a vertex\n", probes.size(), lights.size(),
             settings.rays, settings.light_rays);
  fmt::print("a probe: {:.0f} rays, {:.2f} ms on one thread, {:.2f} million rays a second, {:.1f} lights\n", rays / n,
             ms / n, rays / ms / 1e3, kept / n);
  fmt::print("standard error, weighted by influence: {:.2f} %\n", 100.0 * weighted / influence);
  LocalThinning thinning;
  const SectorLocal thinned = thinnedLocal(local.lights(), probes, kMostLocalBytes, thinning);
  const EncodedLocal encoded = encodeLocal(thinned);
  const SectorLocal decoded = decodedLocal(encoded);
  fmt::print("{} bytes; {} transfers kept, {} dropped with {:.4f} % of the influence, at most {:.2f} % of a probe's\n",
             encoded.bytes(), thinning.kept, thinning.dropped, 100.0 * thinning.lost, 100.0 * thinning.worst_probe);
  fmt::print("encoding: {:.1e} of a transfer's largest number\n", encodingError(thinned, decoded).radiance);
  Random random(1);
  std::vector<Number3> at;
  std::vector<Number3> between;
  for (int i = 0; i < 40; ++i) {
    const auto probe = static_cast<std::size_t>(random.unit() * n);
    at.push_back(sector.probe[probe].position);
    const double x = random.unit() - 0.5;
    between.push_back(at.back() + Number3(4.0 * x, random.unit(), 4.0 * (random.unit() - 0.5)));
    if (!seesEachOther(tracer, at.back(), between.back())) between.pop_back();
  }
  for (const auto& [place, name] : {std::pair(&at, "at virtual lights"), std::pair(&between, "between them")}) {
    const LampError error = lampError(tracer, sector, decoded, *place);
    fmt::print("{} lamps {} against the reference: rms {:.1f} %, mean {:.1f} %\n", place->size(), name,
               100.0 * error.rms, 100.0 * error.mean);
  }
  return 0;
}
