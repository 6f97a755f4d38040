// SPDX-License-Identifier: Apache-2.0
#include "probes/build/level_bake.h"

#include <fmt/format.h>

#include <algorithm>

#include "probes/build/local_bake.h"
#include "probes/geometry/canonical_order.h"
#include "probes/geometry/sector_name.h"
#include "probes/placement/placement.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"

namespace welkin::build {
namespace {

constexpr std::size_t kLargestSectorFile = std::size_t{16} << 20;

transfer::LightTrack trackAlong(const model::LightPath& path) {
  return transfer::trackOf([&](double time_h) { return path.directionAt(time_h); }, kKnotsADay);
}

/// How a file that is there differs from what it must be.
std::string difference(const sectors::SectorFile& file, geometry::SectorId sector, const sectors::BakedFrom& from) {
  if (file.id != sector) return "is of sector " + nameOf(file.id);
  std::string what;
  const auto add = [&](bool differs, const char* name) {
    if (differs) what += (what.empty() ? "" : ", ") + std::string(name);
  };
  add(file.baked_from.surfaces != from.surfaces, "geometry or textures within reach");
  add(file.baked_from.settings != from.settings, "settings");
  add(file.baked_from.light_paths != from.light_paths, "light paths");
  if (what.empty() && file.baked_from.all != from.all) what = "method or format";
  return what.empty() ? "" : "changed: " + what;
}

/// As placement would, before any sector is baked.
void requireFewRooms(const std::vector<geometry::Box>& room, const std::vector<geometry::SectorId>& sectors) {
  if (room.size() <= geometry::kMostRooms) return;
  for (const geometry::SectorId id : sectors) {
    const geometry::Column square = geometry::columnOf(id, 0.0);
    const auto touches = [&](const geometry::Box& b) { return square.touches(b.low.x, b.high.x, b.low.z, b.high.z); };
    const auto count = static_cast<std::size_t>(std::count_if(room.begin(), room.end(), touches));
    if (count > geometry::kMostRooms)
      throw base::Error(base::ExitStatus::content, fmt::format("[[room]]: {} touch sector {}; at most {} may", count,
                                                               nameOf(id), geometry::kMostRooms));
  }
}

}  // namespace

std::filesystem::path sectorPath(const std::filesystem::path& folder, geometry::SectorId sector) {
  return folder / "sectors" / geometry::fileNameOf(sector);
}

LevelBake::LevelBake(geometry::Surfaces surfaces, const BakeSection& section, const model::Sky& sky,
                     std::optional<double> max_error, const base::Progress& progress)
    : surfaces_(std::move(surfaces)),
      section_(section),
      max_error_(max_error.value_or(0.0)),
      ground_albedo_(sky.ground_albedo),
      sun_path_(sky.sun.path) {
  if (!section.transfer.rays && !max_error)
    throw base::Error(
        base::ExitStatus::content,
        "[transfer] rays = \"auto\": needs a budget, --max-error, --quality or max_error of the sky file");
  if (!section.transfer.rays && !(*max_error < 1.0))
    throw base::Error(base::ExitStatus::content,
                      fmt::format("[transfer] rays = \"auto\": needs a budget below 1, and not {}; it "
                                  "comes from --max-error, --quality or max_error of the sky file",
                                  *max_error));
  geometry::OrderedLevel ordered = geometry::orderedLevel(std::move(surfaces_));
  surfaces_ = std::move(ordered.surfaces);
  content_ = std::move(ordered.content);
  if (sky.moon) moon_path_ = sky.moon->path;
  if (section.transfer.sun == transfer::SunTransfer::directional) {
    sun_ = trackAlong(sun_path_);
    if (moon_path_) moon_ = trackAlong(*moon_path_);
  }
  sectors_ = placement::sectorsOf(surfaces_, section_.probes, progress);
  std::sort(sectors_.begin(), sectors_.end());
  requireFewRooms(section_.probes.room, sectors_);
}

double LevelBake::spreadOf(geometry::SectorId sector) const {
  const auto found = std::lower_bound(sectors_.begin(), sectors_.end(), sector);
  return spread_.empty() ? 1.0 : spread_[static_cast<std::size_t>(found - sectors_.begin())];
}

SectorSettings LevelBake::settingsOf(geometry::SectorId sector, double spread) const {
  BakeSection section = sectionOf(sector, section_, columnOfBake(sector));
  section.probes = placement::spreadBy(spread, section.probes);
  section.max_surface_error.reset();  // the spread is what it makes of a sector
  return {std::move(section), max_error_, ground_albedo_, sun_, moon_};
}

geometry::Column LevelBake::columnOfBake(geometry::SectorId sector) const {
  return build::columnOfBake(sector, section_.transfer, surfaces_);
}

sectors::BakedFrom LevelBake::bakedFrom(geometry::SectorId sector, double spread) const {
  return build::bakedFrom(geometry::hashAbout(surfaces_, content_, sector, columnOfBake(sector)),
                          settingsOf(sector, spread));
}

SectorState LevelBake::state(const std::filesystem::path& folder, geometry::SectorId sector) const {
  SectorState state{sector, {}, {}, {}, {}};
  state.from = bakedFrom(sector, spreadOf(sector));
  const std::filesystem::path path = sectorPath(folder, sector);
  std::error_code none;
  if (folder.empty() || !std::filesystem::exists(path, none)) {
    state.stale = "missing";
    return state;
  }
  try {
    state.bytes = base::readFile(path, kLargestSectorFile);
    state.file = sectors::decodeSector(state.bytes, "it");
    state.stale = difference(*state.file, sector, state.from);
  } catch (const base::Error& e) {
    if (e.status() != base::ExitStatus::content) throw;
    state.stale = std::string("unreadable: ") + e.what();
  }
  if (!state.stale.empty()) state.bytes.clear();
  return state;
}

sectors::SectorFile LevelBake::bake(geometry::SectorId sector, const base::Progress& progress,
                                    std::optional<double> spread) const {
  const double factor = spread.value_or(spreadOf(sector));
  geometry::NearSurfaces near = geometry::surfacesAbout(surfaces_, sector, columnOfBake(sector));
  return bakeSector(sector, geometry::withTexels(std::move(near), surfaces_), settingsOf(sector, factor),
                    bakedFrom(sector, factor), progress);
}

SectorPlan LevelBake::plan(geometry::SectorId sector, const base::Progress& progress) const {
  const geometry::Column column = geometry::columnOf(sector, section_.transfer.reach_m);
  const geometry::Surfaces near = geometry::withTexels(geometry::surfacesAbout(surfaces_, sector, column), surfaces_);
  return planSector(sector, near, surfaces_, settingsOf(sector, spreadOf(sector)), progress);
}

std::optional<double> LevelBake::budget() const {
  return section_.transfer.rays ? std::nullopt : std::optional(max_error_);
}

geometry::PlacedSector LevelBake::place(geometry::SectorId sector, const base::Progress& progress) const {
  const geometry::Column column = geometry::columnOf(sector, section_.transfer.reach_m);
  const geometry::Surfaces near = geometry::withTexels(geometry::surfacesAbout(surfaces_, sector, column), surfaces_);
  placement::PlacementReport report;
  geometry::PlacedSector placed = placement::placeSector(
      geometry::Tracer(near), {0, 0}, placement::spreadBy(spreadOf(sector), sectionOf(sector, section_, column).probes),
      report, progress);
  const Number3 corner = geometry::cornerOf(sector);
  placed.id = sector;
  for (geometry::Probe& probe : placed.probe) probe.position += corner;
  for (geometry::Room& room : placed.room) room.box = {room.box.low + corner, room.box.high + corner};
  for (geometry::Door& door : placed.door) door.box = {door.box.low + corner, door.box.high + corner};
  return placed;
}

base::Hash128 LevelBake::geometryHash() const {
  base::Hasher hasher;
  hasher.addAll(std::span(content_));
  return hasher.digest();
}

sectors::LevelIndex LevelBake::index() const {
  sectors::LevelIndex index;
  index.sun = section_.transfer.sun;
  if (index.sun == transfer::SunTransfer::directional) {
    index.sun_path = sun_path_;
    index.moon_path = moon_path_;
  }
  index.scale = section_.scale;
  index.ground_albedo = {ground_albedo_.x, ground_albedo_.y, ground_albedo_.z};
  index.settings = settingsText(section_);
  return index;
}

sectors::SectorEntry entryOf(const sectors::SectorFile& file, std::span<const std::byte> bytes) {
  return {file.id, file.probes.probes(), bytes.size(), base::hashOf(bytes), file.baked_from.all};
}

}  // namespace welkin::build
