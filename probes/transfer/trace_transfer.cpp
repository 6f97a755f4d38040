// SPDX-License-Identifier: Apache-2.0
#include "probes/transfer/trace_transfer.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "probes/transfer/probe_paths.h"
#include "sky/base/error.h"

namespace welkin::transfer {
namespace {

[[noreturn]] void refuseTransfer(const std::string& what) {
  throw base::Error(base::ExitStatus::content, "[transfer] " + what);
}

void check(const TransferSettings& s) {
  if (s.rays < kLeastRays || s.rays > kMostRays || s.rays % kReplicates != 0)
    refuseTransfer(
        fmt::format("rays: {}; allowed: multiples of {} from {} to {}", s.rays, kReplicates, kLeastRays, kMostRays));
  if (s.bounces < 0 || s.bounces > kMostBounces)
    refuseTransfer(fmt::format("bounces: {}; allowed: 0 to {}", s.bounces, kMostBounces));
  if (!(s.max_error >= 0.0 && s.max_error < 1.0))
    refuseTransfer(fmt::format("max-error: {}; allowed: at least 0, less than 1", s.max_error));
  if (!(s.reach_m >= 0.0)) refuseTransfer(fmt::format("reach_m: {}; allowed: at least 0", s.reach_m));
  for (const double albedo : {s.ground_albedo.x, s.ground_albedo.y, s.ground_albedo.z})
    if (!(albedo >= 0.0 && albedo <= 1.0)) refuseTransfer(fmt::format("ground_albedo: {}; allowed: 0 to 1", albedo));
  for (const Number3& light : s.light_directions)
    if (!(std::abs(dot(light, light) - 1.0) < 1e-9))
      refuseTransfer(fmt::format("the light's direction ({}, {}, {}) is not of length 1", light.x, light.y, light.z));
  if (!s.light_directions.empty() && s.light_rays == 0) refuseTransfer("light rays: 0; allowed: at least 1");
}

}  // namespace

OwnLight ownLightAt(const geometry::Tracer& tracer, const TransferSettings& settings, bool emissive,
                    const Number3& position) {
  const std::vector<geometry::StaticLight>& lights = tracer.surfaces().light;
  OwnLight own{emissive, {}, settings.ground_albedo * geometry::onOpenGround(lights) / det::kPi};
  for (const geometry::StaticLight& light : lights)
    if (light.directional || (std::abs(light.position.x - position.x) <= settings.reach_m &&
                              std::abs(light.position.z - position.z) <= settings.reach_m))
      own.light.push_back(light);
  return own;
}

TransferTracer::TransferTracer(const geometry::Tracer& tracer, TransferSettings settings)
    : tracer_(&tracer), settings_(std::move(settings)), emissive_(anyEmissive(tracer.surfaces())) {
  check(settings_);
}

TracedProbe TransferTracer::trace(const Number3& position, geometry::SectorId sector, std::size_t probe,
                                  const base::Progress& progress) const {
  return traceProbe(tracer_->within(position, settings_.reach_m), settings_, circle_,
                    ownLightAt(*tracer_, settings_, emissive_, position), position, sector, probe, progress);
}

std::vector<TracedProbe> TransferTracer::trace(const geometry::PlacedSector& sector) const {
  std::vector<TracedProbe> traced(sector.probe.size());
  tbb::parallel_for(std::size_t{0}, traced.size(),
                    [&](std::size_t i) { traced[i] = trace(sector.probe[i].position, sector.id, i); });
  return traced;
}

ProbeTransfer traceTransfer(const geometry::Tracer& tracer, const Number3& position, const TransferSettings& settings,
                            geometry::SectorId sector, std::size_t probe) {
  return TransferTracer(tracer, settings).trace(position, sector, probe).transfer;
}

}  // namespace welkin::transfer
