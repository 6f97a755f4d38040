// SPDX-License-Identifier: Apache-2.0
// The part of the C interface that relights the resident probes, a budget at a time and by any number of threads.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "probes/level.h"

namespace welkin::probes {
namespace {

/// Chooses the probes of a sector that come next, at most `most`. Returns their number.
std::uint32_t choose(WelkinLevel& level, WelkinSector& sector, std::uint32_t most) {
  if (sector.complete == level.instant) return 0;
  if (sector.pass != level.instant && most >= sector.probes) sector.done = 0;  // all of it with the newest light
  if (sector.done == 0 || sector.pass != level.instant) {  // the rest of a pass takes the newest light
    if (sector.done == 0) sector.pass = level.instant;
    sector.now = sectorLightOf(level.light, *sector.file);
  }
  const std::uint32_t count = std::min(most, sector.probes - sector.done);
  if (count > 0) level.pieces.get()[level.piece_count++] = {&sector, sector.done, level.chosen};
  level.chosen += count;
  sector.done += count;
  if (sector.done < sector.probes) return count;
  sector.complete = sector.pass;
  sector.done = 0;
  sector.fresh = false;
  return count;
}

/// Chooses the probes of sectors that came since: they have no light yet, or that of long ago.
void chooseFresh(WelkinLevel& level, std::uint32_t max_probes) {
  for (std::uint32_t i = 0; i < level.count && level.chosen < max_probes; ++i) {
    WelkinSector& sector = *level.resident.get()[i];
    if (sector.fresh) choose(level, sector, max_probes - level.chosen);
  }
}

std::uint32_t remainingOf(const WelkinLevel& level) {
  std::uint32_t remaining = 0;
  for (std::uint32_t i = 0; i < level.count; ++i) {
    const WelkinSector& s = *level.resident.get()[i];
    if (s.complete != level.instant) remaining += s.pass == level.instant ? s.probes - s.done : s.probes;
  }
  return remaining;
}

WelkinResult check(const char* function, const WelkinLevelLight& light) {
  if (const auto r = core::checkSample(function, "light->sample", light.sample)) return r;
  if (light.sample->coefficient_count < 4)
    return core::refuse(function, "light->sample has %u coefficients, must have 4 or more",
                        light.sample->coefficient_count);
  const struct {
    const char* name;
    float value;
  } factors[] = {{"sky", light.sky}, {"sun_bounce", light.sun_bounce}, {"local", light.local}};
  for (const auto& factor : factors)
    if (!(factor.value >= 0.0F) || !std::isfinite(factor.value))
      return core::refuse(function, "light->%s is %g, must be finite and at least 0", factor.name,
                          double{factor.value});
  return WELKIN_OK;
}

}  // namespace
}  // namespace welkin::probes

using namespace welkin::core;
using namespace welkin::probes;

WelkinResult welkin_level_set_light(WelkinLevel* level, const WelkinLevelLight* light) {
  if (const auto r = nonNull(__func__, {{"level", level}})) return r;
  if (const auto r = sized(__func__, "light", light)) return r;
  WelkinLevelLight wanted = take(*light);
  if (const auto r = check(__func__, wanted)) return r;
  const WelkinSkySample sample = take(*wanted.sample);
  wanted.sample = &sample;
  const LevelLight now = levelLightOf(wanted, *level->index);
  if (level->instant != 0 && std::memcmp(&now, &level->light, sizeof now) == 0) return WELKIN_OK;
  level->light = now;
  ++level->instant;
  return WELKIN_OK;
}

WelkinResult welkin_level_relight_begin(WelkinLevel* level, uint32_t max_probes, uint32_t* count) {
  if (const auto r = nonNull(__func__, {{"level", level}, {"count", count}})) return r;
  if (level->instant == 0) return refuse(__func__, "no light is set");
  if (level->piece_count != 0) return refuse(__func__, "a relighting has begun and must end first");
  level->chosen = 0;
  chooseFresh(*level, max_probes);
  const RelightPiece* pieces = level->pieces.get();
  const std::uint32_t fresh = level->piece_count;
  for (std::uint32_t i = 0; i < level->count && level->chosen < max_probes; ++i, ++level->next) {
    if (level->next >= level->count) level->next = 0;
    WelkinSector& sector = *level->resident.get()[level->next];
    if (std::any_of(pieces, pieces + fresh, [&](const RelightPiece& p) { return p.sector == &sector; })) continue;
    choose(*level, sector, max_probes - level->chosen);
    if (sector.done != 0) break;  // the budget ends within this sector
  }
  *count = level->chosen;
  return WELKIN_OK;
}

WelkinResult welkin_level_relight_range(WelkinLevel* level, uint32_t first, uint32_t count) {
  if (const auto r = nonNull(__func__, {{"level", level}})) return r;
  if (first > level->chosen || count > level->chosen - first)
    return refuse(__func__, "the range %u + %u passes the %u probes of this relighting", first, count, level->chosen);
  const RelightPiece* pieces = level->pieces.get();
  const std::uint32_t end = first + count;
  for (std::uint32_t i = 0; i < level->piece_count; ++i) {
    const std::uint32_t stop = i + 1 < level->piece_count ? pieces[i + 1].start : level->chosen;
    const std::uint32_t from = std::max(pieces[i].start, first);
    const std::uint32_t to = std::min(stop, end);
    if (from >= to) continue;
    WelkinSector& s = *pieces[i].sector;
    relightProbes(s.blocks.get(), s.modes, s.now, s.fixed.get(), pieces[i].first + from - pieces[i].start, to - from,
                  s.light.get());
  }
  return WELKIN_OK;
}

WelkinResult welkin_level_relight_end(WelkinLevel* level, WelkinRelight* result) {
  if (const auto r = nonNull(__func__, {{"level", level}})) return r;
  if (result != nullptr) {
    if (const auto r = sized(__func__, "result", result)) return r;
    WelkinRelight out{};
    out.relit = level->chosen;
    out.remaining = remainingOf(*level);
    give(out, result);
  }
  if (level->chosen > 0) ++level->changes;
  level->piece_count = level->chosen = 0;
  return WELKIN_OK;
}

WelkinResult welkin_level_relight(WelkinLevel* level, uint32_t max_probes, WelkinRelight* result) {
  std::uint32_t count = 0;
  if (const auto r = welkin_level_relight_begin(level, max_probes, &count)) return r;
  welkin_level_relight_range(level, 0, count);
  return welkin_level_relight_end(level, result);
}
