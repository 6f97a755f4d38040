// SPDX-License-Identifier: Apache-2.0
#include "probes/build/local_bake.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "probes/placement/placement.h"
#include "probes/transfer/local_transfer.h"

namespace welkin::probes {
namespace {

LocalSettings localSettings(const SectorSettings& s) {
  const TransferSection& transfer = s.section.transfer;
  LocalSettings settings;
  settings.rays = transfer.rays ? static_cast<std::size_t>(*transfer.rays) : kMostPaths;
  settings.bounces = transfer.bounces;
  settings.nearest_m = kNearest_m;
  settings.reach_m = transfer.reach_m;
  settings.max_error = transfer.rays ? 0.0 : kSamplingShare * s.max_error;
  return settings;
}

LocalSampling samplingOf(const std::vector<LocalProbe>& probes) {
  LocalSampling sampling;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    sampling.rays += probes[i].rays;
    if (probes[i].error > sampling.error) {
      sampling.error = probes[i].error;
      sampling.probe = i;
    }
  }
  return sampling;
}

/// Its probes as its own bake places them.
std::vector<Probe> probesOfNeighbour(const Surfaces& near, SectorId id, const BakeSection& section,
                                     const Checkpoint& checkpoint) {
  const Column column = columnOf(id, section.transfer.reach_m);
  const Surfaces surfaces = withTexels(surfacesWithin(near, column), near);
  return placeProbes(Tracer(surfaces), id, sectionOf(id, section, column).probes, checkpoint);
}

}  // namespace

bool hasLocalTransfer(SectorId sector, const TransferSection& transfer, const Surfaces& level) {
  using Where = LocalLights::Where;
  if (transfer.bounces == 0) return false;  // it is bounced light alone
  const LocalLights& wanted = transfer.local_lights;
  const Column reach = columnOf(sector, transfer.reach_m);
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
                     [&](const PointLight& light) { return reach.holds(light.position); }) ||
         std::any_of(level.spot.begin(), level.spot.end(), [&](const Number3& place) { return reach.holds(place); });
}

std::vector<Number3> virtualLights(const Surfaces& near, const PlacedSector& sector, const BakeSection& section,
                                   const Checkpoint& checkpoint) {
  constexpr std::size_t kSide = 3;
  std::array<std::vector<Probe>, kSide * kSide> placed;
  tbb::parallel_for(std::size_t{0}, placed.size(), [&](std::size_t i) {
    const SectorId id = {sector.id.x - 1 + static_cast<int>(i / kSide), sector.id.z - 1 + static_cast<int>(i % kSide)};
    placed[i] = id == sector.id ? sector.probe : probesOfNeighbour(near, id, section, checkpoint);
  });
  const Column reach = columnOf(sector.id, section.transfer.reach_m);
  std::vector<Number3> lights;
  for (const auto& probes : placed)
    for (const Probe& probe : probes)
      if (reach.holds(probe.position)) lights.push_back(probe.position);
  return lights;
}

BakedLocal bakeLocal(const Tracer& tracer, const Surfaces& near, const PlacedSector& sector,
                     const SectorSettings& settings, const TransferProgress& progress) {
  const LocalTransferTracer transfer(tracer, localSettings(settings),
                                     virtualLights(near, sector, settings.section, [&] { progress(0); }));
  progress(0);
  std::vector<LocalProbe> traced(sector.probe.size());
  tbb::parallel_for(std::size_t{0}, traced.size(), [&](std::size_t i) {
    traced[i] = transfer.trace(sector.probe[i].position, sector.id, i, progress);
  });
  BakedLocal baked;
  const SectorLocal local = thinnedLocal(transfer.lights(), traced, kMostLocalBytes, baked.thinning);
  baked.encoded = encodeLocal(local);
  baked.encoding = encodingError(local, decodedLocal(baked.encoded));
  baked.sampling = samplingOf(traced);
  return baked;
}

}  // namespace welkin::probes
