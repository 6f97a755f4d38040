// SPDX-License-Identifier: Apache-2.0
// The time of a level's bake, by the parts of its sectors, on one thread.
//   level_bench LEVEL.toml
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <array>
#include <chrono>

#include "probes/build/level_bake.h"
#include "probes/build/local_bake.h"
#include "probes/build/subject.h"
#include "probes/geometry/canonical_order.h"
#include "probes/placement/placement.h"
#include "probes/transfer/trace_transfer.h"
#include "sky/base/error.h"

namespace {

using namespace welkin;

enum Part : std::size_t { kWithin, kHash, kScene, kPlacement, kTransfer, kLocal, kAll, kParts };
constexpr std::array<const char*, kParts> kName{"surfaces within reach", "their hash",
                                                "Embree's scenes",       "placement and grid",
                                                "rays of probes",        "local transfer, its neighbours placed again",
                                                "whole sectors"};

class Clock {
 public:
  template <typename Work>
  auto time(Part part, const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    auto result = work();
    seconds_[part] += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
  }
  double seconds(std::size_t part) const { return seconds_[part]; }

 private:
  std::array<double, kParts> seconds_{};
};

void run(const std::filesystem::path& file) {
  build::Subject subject = build::readLevel(file);
  const model::Sky& sky = subject.sky.sky;
  build::BakeSection section = subject.level->section;
  section.transfer.rays = section.transfer.rays.value_or(1024);
  const build::LevelBake bake(std::move(subject.level->surfaces), section, sky, std::nullopt);
  const std::vector<base::Hash128> content = geometry::orderedLevel(bake.surfaces()).content;
  const double reach_m = section.transfer.reach_m;
  Clock clock;
  std::uint64_t rays = 0;
  std::size_t probes = 0;
  for (const geometry::SectorId id : bake.sectors()) {
    // The parts, in the order of bakeSector.
    geometry::NearSurfaces near = clock.time(
        kWithin, [&] { return geometry::surfacesAbout(bake.surfaces(), id, geometry::columnOf(id, reach_m)); });
    const build::SectorSettings settings{
        build::sectionOf(id, section, geometry::columnOf(id, reach_m)), 0.0, sky.ground_albedo, {}, {}};
    clock.time(kHash, [&] {
      return build::bakedFrom(geometry::hashAbout(bake.surfaces(), content, id, geometry::columnOf(id, reach_m)),
                              settings);
    });
    const geometry::Surfaces surfaces =
        clock.time(kWithin, [&] { return geometry::withTexels(std::move(near), bake.surfaces()); });
    const geometry::Tracer tracer = clock.time(kScene, [&] { return geometry::Tracer(surfaces); });
    placement::PlacementReport report;
    const geometry::PlacedSector placed = clock.time(kPlacement, [&] {
      return placement::placeSector(tracer, {0, 0}, settings.section.probes, report);
    });
    transfer::TransferSettings transfer;
    transfer.rays = static_cast<std::size_t>(*section.transfer.rays);
    transfer.bounces = section.transfer.bounces;
    transfer.reach_m = reach_m;
    transfer.ground_albedo = sky.ground_albedo;
    if (section.transfer.sun == transfer::SunTransfer::directional)
      transfer.light_directions =
          transfer::trackOf([&](double time_h) { return sky.sun.path.directionAt(time_h); }, build::kKnotsADay)
              .direction;
    const auto traced = clock.time(kTransfer, [&] { return transfer::TransferTracer(tracer, transfer).trace(placed); });
    for (const transfer::TracedProbe& probe : traced) rays += probe.effort.rays;
    if (!traced.empty() && hasLocalTransfer(id, section.transfer, bake.surfaces())) {
      const geometry::Column column = build::columnOfBake(id, section.transfer, bake.surfaces());
      const geometry::Surfaces wide =
          geometry::withTexels(geometry::surfacesAbout(bake.surfaces(), id, column), bake.surfaces());
      clock.time(kLocal, [&] {
        const build::SectorSettings wanted{build::sectionOf(id, section, column), 0.0, {}, {}, {}};
        return build::bakeLocal(tracer, wide, placed, wanted, {});
      });
    }
    const sectors::SectorFile baked = clock.time(kAll, [&] { return bake.bake(id, {}); });
    probes += baked.probes.probes();
  }
  const double all = clock.seconds(kAll);
  fmt::print("{} sectors, {} probes, {} triangles, {:.2f} M rays without the local transfer's\n", bake.sectors().size(),
             probes, bake.surfaces().triangle.size(), 1e-6 * static_cast<double>(rays));
  double sum = 0.0;
  for (std::size_t part = 0; part < kAll; ++part) {
    fmt::print("{:<44} {:7.3f} s {:5.1f} %\n", kName[part], clock.seconds(part), 100.0 * clock.seconds(part) / all);
    sum += clock.seconds(part);
  }
  fmt::print("{:<44} {:7.3f} s {:5.1f} %\n", "modes, encoding and what else", all - sum, 100.0 * (all - sum) / all);
  fmt::print("{:<44} {:7.3f} s, {:.1f} M rays/s while tracing\n", kName[kAll], all,
             1e-6 * static_cast<double>(rays) / clock.seconds(kTransfer));
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    fmt::print(stderr, "level_bench LEVEL.toml\n");
    return 1;
  }
  try {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    run(arguments[1]);
  } catch (const base::Error& e) {
    fmt::print(stderr, "{}\n", e.what());
    return static_cast<int>(e.status());
  }
  return 0;
}
