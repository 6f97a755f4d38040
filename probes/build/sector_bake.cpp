// SPDX-License-Identifier: Apache-2.0
#include "probes/build/sector_bake.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "format/container.h"
#include "probes/build/local_bake.h"
#include "probes/fit/fit_transfer.h"
#include "probes/placement/cell_cuts.h"
#include "probes/placement/counts.h"
#include "probes/transfer/trace_transfer.h"
#include "sky/base/error.h"

namespace welkin::build {
namespace {

void add(base::Hasher& hasher, const Number3& v) {
  for (const double number : {v.x, v.y, v.z}) hasher.add(number);
}

void add(base::Hasher& hasher, const transfer::LightTrack& track) {
  hasher.addAll(std::span(track.time_h));
  for (const Number3& direction : track.direction) add(hasher, direction);
}

base::Hash128 hashOfSettings(const SectorSettings& s) {
  base::Hasher hasher;
  hasher.add(settingsText(s.section));
  hasher.add(s.section.transfer.rays ? 0.0 : s.max_error);
  add(hasher, s.ground_albedo);
  return hasher.digest();
}

transfer::TransferSettings transferSettings(const SectorSettings& s) {
  transfer::TransferSettings t;
  t.rays = s.section.transfer.rays ? static_cast<std::size_t>(*s.section.transfer.rays) : kMostPaths;
  t.bounces = s.section.transfer.bounces;
  t.ground_albedo = s.ground_albedo;
  t.reach_m = s.section.transfer.reach_m;
  t.light_directions = s.sun.direction;
  t.light_directions.insert(t.light_directions.end(), s.moon.direction.begin(), s.moon.direction.end());
  t.max_error = s.section.transfer.rays ? 0.0 : kSamplingShare * s.max_error;
  return t;
}

std::vector<transfer::TracedProbe> trace(const geometry::Tracer& tracer, const geometry::PlacedSector& placed,
                                         const SectorSettings& settings, const base::Progress& progress) {
  const transfer::TransferTracer transfer(tracer, transferSettings(settings));
  std::vector<transfer::TracedProbe> traced(placed.probe.size());
  tbb::parallel_for(std::size_t{0}, traced.size(), [&](std::size_t i) {
    traced[i] = transfer.trace(placed.probe[i].position, placed.id, i, progress);
  });
  return traced;
}

/// A place of the settings from a sector's corner. Whole micrometres are the same numbers in every sector.
Number3 placeFrom(const Number3& corner, const Number3& p) {
  const auto rounded = [](double v) { return std::round(v * 1e6) / 1e6; };
  return {rounded(p.x - corner.x), p.y, rounded(p.z - corner.z)};
}

/// The traced probes as numbers, the sun's transfer in modes.
transfer::SectorProbes probesOf(const geometry::PlacedSector& placed, const std::vector<transfer::TracedProbe>& traced,
                                const SectorSettings& settings, transfer::SunModesError& error) {
  std::vector<const transfer::ProbeTransfer*> transfers;
  for (const transfer::TracedProbe& t : traced) transfers.push_back(&t.transfer);
  transfer::SunModesFit fit = transfer::fitSunModes(transfers, settings.sun, settings.moon, transfer::kMostSunModes);
  const bool budget = !settings.section.transfer.rays;
  fit = transfer::firstModes(std::move(fit),
                             budget ? transfer::modesFor(fit, kModesShare * settings.max_error) : kSunModes);
  error = fit.error.back();
  transfer::SectorProbes probes;
  probes.id = placed.id;
  for (std::size_t i = 0; i < traced.size(); ++i) {
    probes.position.push_back(placed.probe[i].position);
    probes.transfer.push_back(traced[i].transfer);
  }
  probes.sun = std::move(fit.coefficient);
  probes.modes = std::move(fit.modes);
  return probes;
}

std::vector<placement::ProbeLook> looksOf(const std::vector<transfer::TracedProbe>& traced) {
  std::vector<placement::ProbeLook> looks(traced.size());
  for (std::size_t i = 0; i < traced.size(); ++i)
    for (std::size_t b = 0; b < transfer::kDirections; ++b) {
      looks[i].sky[b] = traced[i].transfer.visibility[b];
      looks[i].lamps[b] = det::luminanceOf(traced[i].transfer.emitted[b]);
    }
  return looks;
}

}  // namespace

geometry::Column columnOfBake(geometry::SectorId sector, const TransferSection& transfer,
                              const geometry::Surfaces& level) {
  return geometry::columnOf(sector,
                            transfer.reach_m + (hasLocalTransfer(sector, transfer, level) ? geometry::kSector_m : 0.0));
}

BakeSection sectionOf(geometry::SectorId sector, const BakeSection& level, const geometry::Column& column) {
  BakeSection section = level;
  section.probes.within.clear();  // the sector is one of them
  std::erase_if(section.probes.add, [&](const Number3& p) { return !column.holds(p); });
  for (auto* boxes : {&section.probes.remove, &section.probes.room})
    std::erase_if(*boxes,
                  [&](const geometry::Box& b) { return !column.touches(b.low.x, b.high.x, b.low.z, b.high.z); });
  std::erase_if(section.probes.door, [&](const placement::RoomDoor& d) {
    return !column.touches(d.box.low.x, d.box.high.x, d.box.low.z, d.box.high.z) ||
           !column.touches(d.room.low.x, d.room.high.x, d.room.low.z, d.room.high.z);
  });
  const Number3 corner = geometry::cornerOf(sector);
  for (placement::RoomDoor& d : section.probes.door)
    for (geometry::Box* b : {&d.room, &d.box}) *b = {placeFrom(corner, b->low), placeFrom(corner, b->high)};
  for (Number3& p : section.probes.add) p = placeFrom(corner, p);
  for (auto* boxes : {&section.probes.remove, &section.probes.room})
    for (geometry::Box& b : *boxes) b = {placeFrom(corner, b.low), placeFrom(corner, b.high)};
  using Where = LocalLights::Where;
  LocalLights& lights = section.transfer.local_lights;
  if (lights.where == Where::listed) {
    const bool is_listed = std::binary_search(lights.sector.begin(), lights.sector.end(), sector);
    lights = {is_listed ? Where::everywhere : Where::nowhere, {}};
  }
  return section;
}

sectors::BakedFrom bakedFrom(const base::Hash128& surfaces, const SectorSettings& settings) {
  sectors::BakedFrom from;
  from.surfaces = surfaces;
  from.settings = hashOfSettings(settings);
  base::Hasher lights;
  add(lights, settings.sun);
  add(lights, settings.moon);
  from.light_paths = lights.digest();
  base::Hasher all;
  all.add(kBakeVersion);
  all.add(format::kLevelVersion);
  all.add(std::string_view(geometry::Tracer::kIsa));
  for (const base::Hash128& part : {from.surfaces, from.settings, from.light_paths}) all.add(part);
  from.all = all.digest();
  return from;
}

sectors::SectorFile placedFile(const geometry::PlacedSector& placed, const placement::PlacementReport& report,
                               const SectorSettings& settings) {
  sectors::SectorFile file;
  static_cast<geometry::SectorGrid&>(file) = placed;
  file.id = placed.id;
  file.sun = settings.section.transfer.sun;
  file.settings = settingsText(settings.section);
  file.placement = placement::countsOf(report);
  return file;
}

sectors::SectorFile bakeSector(geometry::SectorId sector, const geometry::Surfaces& near,
                               const SectorSettings& settings, const sectors::BakedFrom& from,
                               const base::Progress& progress) {
  constexpr geometry::SectorId kHere{0, 0};
  const TransferSection& transfer = settings.section.transfer;
  const bool is_local = hasLocalTransfer(kHere, transfer, near);
  geometry::Surfaces within;
  if (is_local)
    within = geometry::withTexels(geometry::surfacesWithin(near, geometry::columnOf(kHere, transfer.reach_m)), near);
  const geometry::Tracer tracer(is_local ? within : near);
  progress.check();
  placement::PlacementReport report;
  const auto placed = placement::placeSector(tracer, kHere, settings.section.probes, report, progress);
  progress.check();
  std::vector<transfer::TracedProbe> traced = trace(tracer, placed, settings, progress);
  sectors::SectorFile file = placedFile(placed, report, settings);
  file.id = sector;
  file.baked_from = from;
  for (std::size_t i = 0; i < traced.size(); ++i) {
    file.rays += traced[i].effort.rays;
    file.unlit += transfer::isUnlit(traced[i].transfer) ? 1 : 0;
    if (traced[i].effort.error > file.error.sampling) {
      file.error.sampling = traced[i].effort.error;
      file.error.sampling_probe = i;
    }
  }
  if (settings.section.probes.walls == placement::Walls::cut)
    file.cuts = placement::cutCells(tracer, placed, looksOf(traced), is_local, progress);
  std::vector<transfer::ProbeTransfer*> transfers;
  for (transfer::TracedProbe& t : traced) transfers.push_back(&t.transfer);
  if (transfer.fit == Fit::surfaces)
    file.rays += fit::fitTransfer(tracer, placed, file.cuts, transferSettings(settings), transfers, progress).rays;
  const transfer::SectorProbes probes = probesOf(placed, traced, settings, file.error.modes);
  file.probes = transfer::encodeProbes(probes);
  file.error.encoding = transfer::encodingError(probes, transfer::decodedProbes(file.probes, kHere));
  if (!placed.probe.empty() && is_local) {
    file.local = bakeLocal(tracer, near, placed, settings, progress);
    file.rays += file.local->sampling.rays;
  }
  return file;
}

}  // namespace welkin::build
