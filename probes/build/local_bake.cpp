// SPDX-License-Identifier: Apache-2.0
#include "probes/build/local_bake.h"

#include <tbb/parallel_for.h>

#include <array>
#include <atomic>

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

}  // namespace

bool hasLocalTransfer(const TransferSection& transfer, const Surfaces& near) {
  using Where = LocalLights::Where;
  if (transfer.bounces == 0) return false;  // it is bounced light alone
  return transfer.local_lights.where == Where::everywhere ||
         (transfer.local_lights.where == Where::near_lights && !(near.light.empty() && near.spot.empty()));
}

std::vector<Number3> virtualLights(const Tracer& tracer, const PlacedSector& sector, const BakeSection& section) {
  constexpr std::size_t kSide = 3;
  std::array<std::vector<Probe>, kSide * kSide> placed;
  tbb::parallel_for(std::size_t{0}, placed.size(), [&](std::size_t i) {
    const SectorId id = {sector.id.x - 1 + static_cast<int>(i / kSide), sector.id.z - 1 + static_cast<int>(i % kSide)};
    placed[i] = id == sector.id ? sector.probe : placeProbes(tracer, id, section.probes);
  });
  const Column reach = columnOf(sector.id, section.transfer.reach_m);
  std::vector<Number3> lights;
  for (const auto& probes : placed)
    for (const Probe& probe : probes)
      if (reach.holds(probe.position)) lights.push_back(probe.position);
  return lights;
}

std::optional<BakedLocal> bakeLocal(const Tracer& tracer, const PlacedSector& sector, const SectorSettings& settings,
                                    const BakeProgress& progress) {
  const LocalTransferTracer transfer(tracer, localSettings(settings), virtualLights(tracer, sector, settings.section));
  if (!progress(0)) return std::nullopt;
  std::vector<LocalProbe> traced(sector.probe.size());
  std::atomic<bool> go = true;
  tbb::parallel_for(std::size_t{0}, traced.size(), [&](std::size_t i) {
    if (!go) return;
    traced[i] = transfer.trace(sector.probe[i].position, sector.id, i);
    if (!progress(traced[i].rays)) go = false;
  });
  if (!go) return std::nullopt;
  BakedLocal baked;
  const SectorLocal local = thinnedLocal(transfer.lights(), traced, kMostLocalBytes, baked.thinning);
  baked.encoded = encodeLocal(local);
  baked.encoding = encodingError(local, decodedLocal(baked.encoded));
  baked.sampling = samplingOf(traced);
  return baked;
}

}  // namespace welkin::probes
