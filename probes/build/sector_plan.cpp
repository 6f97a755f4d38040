// SPDX-License-Identifier: Apache-2.0
#include "probes/build/sector_plan.h"

#include <algorithm>

#include "probes/build/local_bake.h"
#include "probes/fit/fit_transfer.h"
#include "probes/transfer/local_transfer.h"

namespace welkin::build {
namespace {

/// As many probes as were placed, all dark, with as many modes of the sun as a bake without a budget makes.
transfer::SectorProbes darkProbes(const geometry::PlacedSector& placed, const geometry::Surfaces& near,
                                  const SectorSettings& settings) {
  transfer::SectorProbes probes;
  probes.id = placed.id;
  for (const geometry::Probe& probe : placed.probe) probes.position.push_back(probe.position);
  probes.transfer.resize(placed.probe.size());
  transfer::SunModes& modes = probes.modes;
  modes.sun_time_h = settings.sun.time_h;
  modes.moon_time_h = settings.moon.time_h;
  const std::size_t count = std::min({kSunModes, 3 * modes.knots(), transfer::kDirections * placed.probe.size()});
  modes.value.resize(count * modes.knots());
  probes.sun.resize(placed.probe.size());
  for (transfer::SunCoefficients& sun : probes.sun)
    for (std::vector<double>& direction : sun) direction.resize(count);
  const bool emits = !near.light.empty() || std::any_of(near.material.begin(), near.material.end(),
                                                        [](const auto& m) { return !(m.emission == Number3(0.0)); });
  if (emits && !probes.transfer.empty()) probes.transfer.front().emitted.front() = Number3(1.0);
  return probes;
}

/// Bytes of a sector's local transfer, at most: it may have as many virtual lights as nine sectors like it have probes.
std::size_t localBytes(std::size_t count) {
  const std::size_t lights = 9 * count;
  const std::size_t most = transfer::kVirtualLightBytes * lights +
                           count * (1 + transfer::kLocalTransferBytes * std::min(lights, transfer::kMostLocalLights));
  return std::min(most, transfer::kMostLocalBytes);
}

/// Rays of all probes, at most: a path tests its way and some lights at every surface. Local transfer also traces the
/// paths that choose its lights.
std::optional<std::uint64_t> mostRays(const SectorPlan& plan, const SectorSettings& settings) {
  const TransferSection& t = settings.section.transfer;
  if (plan.probes == 0) return 0;
  if (!t.rays) return std::nullopt;
  const auto paths = static_cast<std::uint64_t>(*t.rays);
  const auto bounces = static_cast<std::uint64_t>(t.bounces);
  const std::size_t lights = settings.sun.direction.size() + settings.moon.direction.size();
  const std::uint64_t tested = std::min(transfer::TransferSettings{}.light_rays, lights);
  const std::uint64_t rays_of_path = 1 + bounces * (1 + tested);
  std::uint64_t rays = paths * rays_of_path;
  if (t.fit == Fit::surfaces) {
    constexpr fit::FitSettings kFit;
    rays += (kFit.surface_points + kFit.air_points) * kFit.paths * rays_of_path;
  }
  if (plan.has_local)
    rays += 2 * paths * bounces * (1 + transfer::LocalSettings{}.light_rays) + 9 * geometry::kMostProbes;
  return plan.probes * rays;
}

}  // namespace

SectorPlan planSector(geometry::SectorId sector, const geometry::Surfaces& near, const geometry::Surfaces& level,
                      const SectorSettings& settings, const base::Progress& progress) {
  placement::PlacementReport report;
  const auto placed = placement::placeSector(geometry::Tracer(near), {0, 0}, settings.section.probes, report, progress);
  sectors::SectorFile file = placedFile(placed, report, settings);
  file.probes = transfer::encodeProbes(darkProbes(placed, near, settings));
  SectorPlan plan;
  plan.probes = placed.probe.size();
  plan.has_local = plan.probes > 0 && hasLocalTransfer(sector, settings.section.transfer, level);
  plan.bytes = sectors::encodeSector(file).size() + (plan.has_local ? localBytes(plan.probes) : 0);
  plan.rays = mostRays(plan, settings);
  return plan;
}

}  // namespace welkin::build
