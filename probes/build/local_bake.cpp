// SPDX-License-Identifier: Apache-2.0
#include "probes/build/local_bake.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "probes/placement/placement.h"
#include "probes/transfer/local_transfer.h"

namespace welkin::build {
namespace {

transfer::LocalSettings localSettings(const SectorSettings& s) {
  const TransferSection& transfer = s.section.transfer;
  transfer::LocalSettings settings;
  settings.rays = transfer.rays ? static_cast<std::size_t>(*transfer.rays) : kMostPaths;
  settings.bounces = transfer.bounces;
  settings.nearest_m = kNearest_m;
  settings.reach_m = transfer.reach_m;
  settings.max_error = transfer.rays ? 0.0 : kSamplingShare * s.max_error;
  return settings;
}

sectors::LocalSampling samplingOf(const std::vector<transfer::LocalProbe>& probes) {
  sectors::LocalSampling sampling;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    sampling.rays += probes[i].rays;
    if (probes[i].error > sampling.error) {
      sampling.error = probes[i].error;
      sampling.probe = i;
    }
  }
  return sampling;
}

/// Its probes as its own bake places them, in the world of `near`.
std::vector<geometry::Probe> probesOfNeighbour(const geometry::Surfaces& near, geometry::SectorId id,
                                               const BakeSection& section, const base::Progress& progress) {
  const geometry::Column column = geometry::columnOf(id, section.transfer.reach_m);
  const geometry::Surfaces surfaces = geometry::withTexels(geometry::surfacesAbout(near, id, column), near);
  std::vector<geometry::Probe> probes =
      placement::placeProbes(geometry::Tracer(surfaces), {0, 0}, sectionOf(id, section, column).probes, progress);
  for (geometry::Probe& probe : probes) probe.position += geometry::cornerOf(id);
  return probes;
}

}  // namespace

bool hasLocalTransfer(geometry::SectorId sector, const TransferSection& transfer, const geometry::Surfaces& level) {
  using Where = LocalLights::Where;
  if (transfer.bounces == 0) return false;  // it is bounced light alone
  const LocalLights& wanted = transfer.local_lights;
  const geometry::Column reach = geometry::columnOf(sector, transfer.reach_m);
  switch (wanted.where) {
    case Where::nowhere:
      return false;
    case Where::everywhere:
      return true;
    case Where::listed:
      return std::binary_search(wanted.sector.begin(), wanted.sector.end(), sector);
    case Where::near_lights:
      break;
  }
  return std::any_of(level.light.begin(), level.light.end(),
                     [&](const geometry::StaticLight& l) { return !l.directional && reach.holds(l.position); });
}

std::vector<Number3> virtualLights(const geometry::Surfaces& near, const geometry::PlacedSector& sector,
                                   const BakeSection& section, const base::Progress& progress) {
  constexpr std::size_t kSide = 3;
  std::array<std::vector<geometry::Probe>, kSide * kSide> placed;
  tbb::parallel_for(std::size_t{0}, placed.size(), [&](std::size_t i) {
    const geometry::SectorId id = {sector.id.x - 1 + static_cast<int>(i / kSide),
                                   sector.id.z - 1 + static_cast<int>(i % kSide)};
    placed[i] = id == sector.id ? sector.probe : probesOfNeighbour(near, id, section, progress);
  });
  const geometry::Column reach = geometry::columnOf(sector.id, section.transfer.reach_m);
  std::vector<Number3> lights;
  for (const auto& probes : placed)
    for (const geometry::Probe& probe : probes)
      if (reach.holds(probe.position)) lights.push_back(probe.position);
  return lights;
}

sectors::BakedLocal bakeLocal(const geometry::Tracer& tracer, const geometry::Surfaces& near,
                              const geometry::PlacedSector& sector, const SectorSettings& settings,
                              const base::Progress& progress) {
  const transfer::LocalTransferTracer transfer(tracer, localSettings(settings),
                                               virtualLights(near, sector, settings.section, progress));
  progress.check();
  std::vector<transfer::LocalProbe> traced(sector.probe.size());
  tbb::parallel_for(std::size_t{0}, traced.size(), [&](std::size_t i) {
    traced[i] = transfer.trace(sector.probe[i].position, sector.id, i, progress);
  });
  sectors::BakedLocal baked;
  const transfer::SectorLocal local =
      transfer::thinnedLocal(transfer.lights(), traced, transfer::kMostLocalBytes, baked.thinning);
  baked.encoded = transfer::encodeLocal(local);
  baked.encoding = transfer::encodingError(local, transfer::decodedLocal(baked.encoded));
  baked.sampling = samplingOf(traced);
  return baked;
}

}  // namespace welkin::build
