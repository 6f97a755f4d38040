// SPDX-License-Identifier: Apache-2.0
// The part of the C interface that opens a level's index and its sectors, and closes them.
#include <algorithm>
#include <cstdio>
#include <new>
#include <utility>

#include "core/sky.h"
#include "format/sector_check.h"
#include "probes/level.h"

namespace welkin::probes {
namespace {

using core::fail;
using format::spanOf;

bool isSame(const flatbuffers::Vector<double>* a, const flatbuffers::Vector<double>* b) {
  const auto x = spanOf(a), y = spanOf(b);
  return std::equal(x.begin(), x.end(), y.begin(), y.end());
}

/// Whether two paths, of which each may be missing, are the same numbers.
bool isSame(const format::LightPath* a, const format::LightPath* b) {
  if (a == nullptr || b == nullptr) return a == b;
  return a->latitude_rad() == b->latitude_rad() && a->declination_rad() == b->declination_rad() &&
         a->transit_h() == b->transit_h() && a->north_offset_rad() == b->north_offset_rad() &&
         isSame(a->key_time_h(), b->key_time_h()) && isSame(a->key_azimuth_rad(), b->key_azimuth_rad()) &&
         isSame(a->key_elevation_rad(), b->key_elevation_rad());
}

/// WELKIN_OK if the probes of the level can be lit by the sky.
WelkinResult checkSky(const format::Level& level, const format::Sky& sky, WelkinMessage* message) {
  if (level.sun() == format::SunTransfer::directional) {
    if (!isSame(level.sun_path(), sky.sun()->path()))
      return fail(message, WELKIN_ERROR_CONTENT,
                  "the level's bounced sun was baked along another path than that of the sky's sun: bake it again");
    if (!isSame(level.moon_path(), sky.moon() == nullptr ? nullptr : sky.moon()->path()))
      return fail(
          message, WELKIN_ERROR_CONTENT,
          "the level's bounced moonlight was baked along another path than that of the sky's moon: bake it again");
  }
  const format::Rgb* baked = level.ground_albedo();
  const format::Rgb& albedo = *sky.ground_albedo();
  if (baked != nullptr && (baked->r() != albedo.r() || baked->g() != albedo.g() || baked->b() != albedo.b()))
    return fail(message, WELKIN_ERROR_CONTENT,
                "the level was baked over ground of albedo %g %g %g, the sky has %g %g %g: bake it again",
                double{baked->r()}, double{baked->g()}, double{baked->b()}, double{albedo.r()}, double{albedo.g()},
                double{albedo.b()});
  return WELKIN_OK;
}

/// Fault of a file's content as an error.
WelkinResult checkFault(const format::Fault& fault, WelkinMessage* message) {
  return fault.what == nullptr ? WELKIN_OK : fail(message, WELKIN_ERROR_CONTENT, "%s %s", fault.what, fault.must);
}

WelkinResult openFrom(const WelkinOpenInfo& info, const WelkinSky& sky, const WelkinLevelLimits& limits,
                      WelkinLevel** level, WelkinMessage* message) {
  WelkinLevel opened;
  if (const auto r = core::readBytes(info, opened.source, message)) return r;
  const format::File* file = nullptr;
  if (const auto r = core::rootOf(opened.source.bytes, format::Kind::level, &file, message)) return r;
  if (const auto r = checkFault(format::levelFaultOf(*file), message)) return r;
  opened.index = file->level();
  if (const auto r = checkSky(*opened.index, *sky.file->sky(), message)) return r;
  opened.capacity = limits.sector_capacity == 0 ? 64 : limits.sector_capacity;
  std::uint32_t buckets = 4;
  while (buckets < 4 * opened.capacity) buckets *= 2;
  opened.table_mask = buckets - 1;
  const core::HostMemory memory = opened.source.memory;
  void* room = nullptr;
  if (!opened.resident.allocate(memory, opened.capacity) || !opened.pieces.allocate(memory, opened.capacity + 1) ||
      !opened.table.allocate(memory, buckets) || !openTable(memory, opened.capacity, opened.lights) ||
      !openLamps(memory, limits.light_capacity == 0 ? kDefaultLamps : limits.light_capacity, opened.lamps) ||
      (room = memory.allocate(sizeof(WelkinLevel), alignof(WelkinLevel))) == nullptr)
    return fail(message, WELKIN_ERROR_MEMORY, "out of memory");
  std::fill_n(opened.table.get(), buckets, 0U);
  *level = new (room) WelkinLevel(std::move(opened));
  return WELKIN_OK;
}

/// The entry of the index for a sector, or null.
const format::SectorEntry* entryOf(const format::Level& level, std::int32_t x, std::int32_t z) {
  if (level.sectors() == nullptr) return nullptr;
  for (const format::SectorEntry* s : *level.sectors())
    if (s->x() == x && s->z() == z) return s;
  return nullptr;
}

/// Marks the cells that walls part. False when memory runs out.
bool markCuts(const format::CellCuts& cuts, const core::HostMemory& memory, core::HostArray<std::uint64_t>& cut) {
  if (cuts.empty()) return true;
  if (!cut.allocate(memory, format::kGridCells / 64)) return false;
  std::fill_n(cut.get(), format::kGridCells / 64, std::uint64_t{0});
  for (const std::uint16_t cell : cuts.cell) cut.get()[cell / 64] |= std::uint64_t{1} << (cell % 64);
  return true;
}

/// The grid, with cells without a probe named as the nearest cell that has one, in steps to one of six neighbours.
void fillHoles(std::span<const std::uint8_t> grid, std::array<std::uint8_t, format::kGridCells>& filled) {
  constexpr int kSide = format::kCellsAcross;
  constexpr int kSteps[6][3] = {{0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}, {0, 0, -1}, {0, 0, 1}};
  std::array<std::uint16_t, format::kGridCells> queue;
  std::size_t end = 0;
  std::copy(grid.begin(), grid.end(), filled.begin());
  for (std::size_t cell = 0; cell < filled.size(); ++cell)
    if (filled[cell] != format::kNoProbe) queue[end++] = static_cast<std::uint16_t>(cell);
  for (std::size_t begin = 0; begin < end; ++begin) {
    const int cell = queue[begin];
    for (const auto& step : kSteps) {
      const int x = cell % kSide + step[0], y = cell / kSide % kSide + step[1], z = cell / (kSide * kSide) + step[2];
      if (std::min({x, y, z}) < 0 || std::max({x, y, z}) >= kSide) continue;
      const auto next = static_cast<std::size_t>(x + kSide * (y + kSide * z));
      if (filled[next] != format::kNoProbe) continue;
      filled[next] = filled[static_cast<std::size_t>(cell)];
      queue[end++] = static_cast<std::uint16_t>(next);
    }
  }
}

WelkinResult openSector(const WelkinLevel& level, std::span<const std::byte> bytes, WelkinSector** sector,
                        WelkinMessage* message) {
  const format::File* file = nullptr;
  if (const auto r = core::rootOf(bytes, format::Kind::sector, &file, message)) return r;
  if (const auto r = checkFault(format::sectorFaultOf(*file), message)) return r;
  WelkinSector opened;
  opened.memory = level.source.memory;
  opened.level = &level;
  opened.file = file->sector();
  opened.grid = {spanOf(opened.file->grid()), opened.file->low_y(), opened.file->cell_height_m(),
                 format::cutsOf(*opened.file)};
  opened.x = opened.file->x();
  opened.z = opened.file->z();
  const format::SectorEntry* entry = entryOf(*level.index, opened.x, opened.z);
  if (entry == nullptr)
    return fail(message, WELKIN_ERROR_CONTENT, "the index has no sector (%d, %d)", opened.x, opened.z);
  const format::Hash hash = format::hashOf(bytes);
  if (hash.low() != entry->checksum().low() || hash.high() != entry->checksum().high())
    return fail(message, WELKIN_ERROR_CONTENT,
                "sector (%d, %d) is not the file that the index names: the two are of different bakes", opened.x,
                opened.z);
  if (opened.file->sun() != level.index->sun())
    return fail(message, WELKIN_ERROR_CONTENT, "sector (%d, %d) and the index differ in the form of the bounced sun",
                opened.x, opened.z);
  const format::Probes& probes = *opened.file->probes();
  opened.probes = format::probesOf(*opened.file);
  opened.modes = spanOf(probes.mode_scale()).size();
  opened.has_rooms = opened.file->room() != nullptr;
  void* room = nullptr;
  const std::size_t numbers = kColours * opened.probes;
  if (!markCuts(opened.grid.cuts, opened.memory, opened.cut) || !packProbes(probes, opened.memory, opened.blocks) ||
      !unpackEmitted(probes, opened.memory, opened.fixed) || !openLights(opened) || !openTransfers(opened) ||
      (numbers > 0 &&
       (!opened.light.allocate(opened.memory, numbers) || !opened.packed.allocate(opened.memory, opened.probes))) ||
      (room = opened.memory.allocate(sizeof(WelkinSector), alignof(WelkinSector))) == nullptr)
    return fail(message, WELKIN_ERROR_MEMORY, "out of memory");
  relightProbes(opened.blocks.get(), opened.modes, sectorLightOf(uniformSky(), *opened.file), nullptr, 0, opened.probes,
                opened.light.get());
  opened.far_tile = farTileOf(*opened.file, opened.light.get());
  if (numbers > 0) std::fill_n(opened.light.get(), numbers, 0.0F);
  fillHoles(opened.grid.grid, opened.filled);
  opened.bytes = sizeof(WelkinSector) + (opened.cut.get() == nullptr ? 0 : format::kGridCells / 8) +
                 sizeof(float) * numbers * (opened.fixed.get() == nullptr ? 1 : 2) +
                 opened.probes * sizeof *opened.packed.get() +
                 (opened.probes + kBlock - 1) / kBlock * BlockLayout{opened.modes}.bytes() + localBytes(opened);
  *sector = new (room) WelkinSector(std::move(opened));
  return WELKIN_OK;
}

}  // namespace
}  // namespace welkin::probes

using namespace welkin::core;

WelkinResult welkin_level_open(const WelkinOpenInfo* info, const WelkinSky* sky, const WelkinLevelLimits* limits,
                               WelkinLevel** level, WelkinMessage* message) {
  if (level != nullptr) *level = nullptr;
  const auto check = [&]() -> WelkinResult {
    if (const auto r = sized("welkin_level_open", "info", info)) return r;
    if (const auto r = nonNull("welkin_level_open", {{"sky", sky}, {"level", level}})) return r;
    if (limits != nullptr) {
      if (const auto r = sized("welkin_level_open", "limits", limits)) return r;
      const WelkinLevelLimits wanted = take(*limits);
      if (wanted.sector_capacity > 65535)
        return refuse("welkin_level_open", "limits->sector_capacity is %u, must be 0 to 65535", wanted.sector_capacity);
      if (wanted.light_capacity > welkin::probes::kMostLamps)
        return refuse("welkin_level_open", "limits->light_capacity is %u, must be 0 to %u", wanted.light_capacity,
                      welkin::probes::kMostLamps);
    }
    return checkOpenInfo("welkin_level_open", take(*info));
  };
  if (const auto r = check()) return fail(message, r, "%s", welkin_argument_error());
  const WelkinOpenInfo source = take(*info);
  const WelkinLevelLimits wanted = limits == nullptr ? WelkinLevelLimits{} : take(*limits);
  WelkinMessage reason{};
  const WelkinResult result = welkin::probes::openFrom(source, *sky, wanted, level, &reason);
  if (result == WELKIN_OK && source.log != nullptr) {
    char text[256];
    std::snprintf(text, sizeof text, "%.160s: format version %u, %u sectors",
                  source.path != nullptr ? source.path : "a level in memory", welkin::format::kLevelVersion,
                  (*level)->index->sectors() == nullptr ? 0U : (*level)->index->sectors()->size());
    source.log->write(source.log->user, WELKIN_LOG_INFO, text);
  }
  return endOpen(__func__, source, result, reason, message);
}

void welkin_level_close(WelkinLevel* level) {
  if (level == nullptr) return;
  for (std::uint32_t i = 0; i < level->count; ++i) {
    level->resident.get()[i]->resident = false;
    welkin_sector_close(level->resident.get()[i]);
  }
  const HostMemory memory = level->source.memory;
  level->~WelkinLevel();
  memory.free(level, sizeof(WelkinLevel));
}

WelkinResult welkin_sector_open(const WelkinLevel* level, const void* data, size_t size, WelkinSector** sector,
                                WelkinMessage* message) {
  if (sector != nullptr) *sector = nullptr;
  if (const auto r = nonNull(__func__, {{"level", level}, {"data", data}, {"sector", sector}}))
    return fail(message, r, "%s", welkin_argument_error());
  WelkinMessage reason{};
  const WelkinResult result =
      welkin::probes::openSector(*level, {static_cast<const std::byte*>(data), size}, sector, &reason);
  if (result == WELKIN_ERROR_ARGUMENT) refuse(__func__, "%s", reason.text);
  return result == WELKIN_OK ? result : fail(message, result, "%s", reason.text);
}

void welkin_sector_close(WelkinSector* sector) {
  if (sector == nullptr || sector->resident) return;
  const HostMemory memory = sector->memory;
  sector->~WelkinSector();
  memory.free(sector, sizeof(WelkinSector));
}
