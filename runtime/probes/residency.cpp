// SPDX-License-Identifier: Apache-2.0
// The part of the C interface that makes sectors resident and describes a level.
#include <cmath>

#include "format/domain_check.h"
#include "probes/level.h"

namespace welkin::probes {
namespace {

/// Bucket of the sector (x, z), or the free one where it would be.
std::uint32_t bucketOf(const WelkinLevel& level, std::int32_t x, std::int32_t z) {
  // A step in z goes on by the golden ratio of the table, so that sectors near each other seldom share a bucket.
  const std::uint32_t step = static_cast<std::uint32_t>((level.table_mask * std::uint64_t{0x9e3779b9U}) >> 32) | 1U;
  std::uint32_t bucket = (static_cast<std::uint32_t>(x) + static_cast<std::uint32_t>(z) * step) & level.table_mask;
  for (;; bucket = (bucket + 1) & level.table_mask) {
    const std::uint32_t entry = level.table.get()[bucket];
    if (entry == 0) return bucket;
    const WelkinSector& sector = *level.resident.get()[entry - 1];
    if (sector.x == x && sector.z == z) return bucket;
  }
}

/// Frees a bucket and moves up the entries that follow it.
void clearBucket(WelkinLevel& level, std::uint32_t bucket) {
  std::uint32_t* table = level.table.get();
  table[bucket] = 0;
  for (std::uint32_t next = (bucket + 1) & level.table_mask; table[next] != 0; next = (next + 1) & level.table_mask) {
    const std::uint32_t entry = table[next];
    table[next] = 0;
    const WelkinSector& sector = *level.resident.get()[entry - 1];
    table[bucketOf(level, sector.x, sector.z)] = entry;
  }
}

}  // namespace

WelkinSector* residentAt(const WelkinLevel& level, std::int32_t x, std::int32_t z) {
  const std::uint32_t entry = level.table.get()[bucketOf(level, x, z)];
  return entry == 0 ? nullptr : level.resident.get()[entry - 1];
}

}  // namespace welkin::probes

using namespace welkin::core;
using namespace welkin::probes;

WelkinResult welkin_level_add(WelkinLevel* level, WelkinSector* sector) {
  if (const auto r = nonNull(__func__, {{"level", level}, {"sector", sector}})) return r;
  if (sector->level != level) return refuse(__func__, "the sector was opened for another level");
  if (sector->resident || residentAt(*level, sector->x, sector->z) != nullptr)
    return refuse(__func__, "the sector (%d, %d) is already resident", sector->x, sector->z);
  if (level->count == level->capacity) return WELKIN_ERROR_MEMORY;
  const std::uint32_t bucket = bucketOf(*level, sector->x, sector->z);
  sector->slot = level->count++;
  sector->resident = sector->fresh = true;
  sector->complete = sector->pass = 0;
  sector->done = 0;
  level->resident.get()[sector->slot] = sector;
  level->table.get()[bucket] = sector->slot + 1;
  level->probes += sector->probes;
  ++level->changes;
  sector->arrival = ++level->residents;
  lightsCome(*level, *sector);
  return WELKIN_OK;
}

WelkinResult welkin_level_remove(WelkinLevel* level, int32_t x, int32_t z, WelkinSector** sector) {
  if (const auto r = nonNull(__func__, {{"level", level}, {"sector", sector}})) return r;
  if (level->piece_count != 0) return refuse(__func__, "a relighting has begun and must end first");
  *sector = residentAt(*level, x, z);
  if (*sector == nullptr) return WELKIN_OK;
  WelkinSector& gone = **sector;
  lightsLeave(*level, gone);
  WelkinSector** resident = level->resident.get();
  clearBucket(*level, bucketOf(*level, x, z));
  if (gone.slot + 1 != level->count) {  // the last sector moves to the free slot
    WelkinSector* last = resident[level->count - 1];
    level->table.get()[bucketOf(*level, last->x, last->z)] = gone.slot + 1;
    resident[gone.slot] = last;
    last->slot = gone.slot;
  }
  --level->count;
  level->probes -= gone.probes;
  ++level->changes;
  ++level->residents;
  gone.resident = false;
  return WELKIN_OK;
}

WelkinResult welkin_level_farthest(const WelkinLevel* level, const float position[3], int32_t* x, int32_t* z) {
  if (const auto r = nonNull(__func__, {{"level", level}, {"position", position}, {"x", x}, {"z", z}})) return r;
  if (level->count == 0) return refuse(__func__, "no sector is resident");
  if (!std::isfinite(position[0]) || !std::isfinite(position[2])) return refuse(__func__, "position must be finite");
  double most = -1.0;
  for (std::uint32_t i = 0; i < level->count; ++i) {
    const WelkinSector& s = *level->resident.get()[i];
    const double away =
        std::hypot((s.x + 0.5) * kSector_m - double{position[0]}, (s.z + 0.5) * kSector_m - double{position[2]});
    // Of equally far ones the first in x, then z, so that the order of arrival does not matter.
    if (away > most || (away == most && (s.x < *x || (s.x == *x && s.z < *z)))) {
      most = away;
      *x = s.x;
      *z = s.z;
    }
  }
  return WELKIN_OK;
}

WelkinResult welkin_level_info(const WelkinLevel* level, WelkinLevelInfo* info) {
  if (const auto r = nonNull(__func__, {{"level", level}})) return r;
  if (const auto r = sized(__func__, "info", info)) return r;
  WelkinLevelInfo out{};
  if (level->index->sectors() != nullptr) {
    out.sector_count = level->index->sectors()->size();
    for (const auto* s : *level->index->sectors()) out.probe_count += s->probes();
  }
  out.sector_capacity = level->capacity;
  out.light_capacity = level->lamps.capacity;
  out.resident_sectors = level->count;
  out.resident_probes = level->probes;
  for (std::uint32_t i = 0; i < level->count; ++i) out.resident_bytes += level->resident.get()[i]->bytes;
  out.sun_transfer = static_cast<WelkinSunTransfer>(level->index->sun());
  out.sky_scale = static_cast<float>(level->index->sky_scale());
  out.sun_bounce_scale = static_cast<float>(level->index->sun_bounce_scale());
  give(out, info);
  return WELKIN_OK;
}

WelkinResult welkin_level_entry(const WelkinLevel* level, uint32_t index, WelkinSectorEntry* entry) {
  if (const auto r = nonNull(__func__, {{"level", level}, {"entry", entry}})) return r;
  const std::uint32_t count = level->index->sectors() == nullptr ? 0 : level->index->sectors()->size();
  if (index >= count) return refuse(__func__, "index is %u, must be below %u", index, count);
  const auto* s = level->index->sectors()->Get(index);
  *entry = {s->x(), s->z(), s->probes(), 0, s->bytes()};
  return WELKIN_OK;
}
