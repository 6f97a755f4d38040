// SPDX-License-Identifier: Apache-2.0
// The part of the C interface that sets dynamic lights.
#include "probes/lamps.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "probes/level.h"

namespace welkin::probes {
namespace {

static_assert(sizeof(WelkinPointLight) == 12 * sizeof(float));  // no padding: bytes tell whether it changed
static_assert(sizeof(Lamp) == 320, "level.h states it");

constexpr float kPi = 3.14159274F;  // the float next to pi

WelkinResult checkLamp(const char* function, std::uint32_t i, const WelkinPointLight& light) {
  for (const float v : light.position)
    if (!(std::abs(v) < 0x1p30F))
      return core::refuse(function, "the position of light %u has a coordinate %g, must be below 2^30 m", i, double{v});
  for (const float v : light.intensity)
    if (!(v >= 0.0F && v <= 1e15F))
      return core::refuse(function, "the intensity of light %u has a channel %g, must be 0 to 1e15", i, double{v});
  if (light.outer_rad == 0.0F) return WELKIN_OK;
  if (!(light.inner_rad >= 0.0F && light.inner_rad <= light.outer_rad && light.outer_rad <= kPi))
    return core::refuse(function, "the cone of light %u is %g to %g, must be 0 <= inner <= outer <= pi", i,
                        double{light.inner_rad}, double{light.outer_rad});
  return core::unit(function, "the direction of a light", light.direction);
}

/// Whether a lamp may have to do with the lights of a sector.
bool isWithinReach(const Lamp& lamp, const SectorLights& lights) {
  double squared = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double p = double{lamp.light.position[axis]};
    const double away = std::max({lights.low[axis] - kSameLight_m - p, p - lights.high[axis] - kSameLight_m, 0.0});
    squared += away * away;
  }
  return std::sqrt(squared) <= std::min(lamp.reach_m, kFarthestLight_m);
}

/// After lists came or went: makes shares name first ones again.
void renameShares(WelkinLevel& level, const SectorLights& lights) {
  for (std::uint32_t i = 0; i < level.lamps.count; ++i) {
    Lamp& lamp = level.lamps.lamp.get()[i];
    if (isWithinReach(lamp, lights)) lamp.is_stale = 1;
    for (std::uint32_t s = 0; s < lamp.shares; ++s)
      if (lamp.share[s].light != kNoLight) lamp.share[s].light = lightAt(level.lights, lamp.share[s].light).first;
  }
}

/// Has the virtual lights of a lamp get their colour anew.
void touchLights(const LightTable& table, const Lamp& lamp) {
  for (std::uint32_t s = 0; s < lamp.shares; ++s) {
    if (lamp.share[s].light == kNoLight) continue;
    lightAt(table, lamp.share[s].light).touched = 1;
    for (LightHandle l = lamp.share[s].light; l != kNoLight; l = lightAt(table, l).same) {
      std::fill_n(lightAt(table, l).colour, 3, 0.0F);
      table.sector.get()[l >> 16]->lights.is_changed = true;
    }
  }
}

/// Shares a lamp anew where it has changed or is stale. Returns whether it did.
bool update(const LightTable& table, const Sight& sight, Lamp& lamp, const WelkinPointLight& wanted) {
  if (lamp.is_stale == 0 && std::memcmp(&lamp.light, &wanted, sizeof wanted) == 0) return false;
  Lamp now{};
  now.light = wanted;
  shareLamp(table, sight, now);
  const bool is_same = now.shares == lamp.shares &&
                       std::memcmp(now.share, lamp.share, now.shares * sizeof(LightShare)) == 0 &&
                       std::memcmp(now.light.intensity, lamp.light.intensity, sizeof now.light.intensity) == 0;
  if (!is_same) {
    touchLights(table, lamp);
    touchLights(table, now);
  }
  lamp = now;
  return true;
}

/// Sums the colours of the touched lights, in the order of the lamps, and shows them in every list.
void colourLights(WelkinLevel& level) {
  const LightTable& table = level.lights;
  for (std::uint32_t i = 0; i < level.lamps.count; ++i) {
    const Lamp& lamp = level.lamps.lamp.get()[i];
    for (std::uint32_t s = 0; s < lamp.shares; ++s) {
      if (lamp.share[s].light == kNoLight) continue;
      VirtualLight& light = lightAt(table, lamp.share[s].light);
      if (light.touched == 0) continue;
      for (std::size_t c = 0; c < 3; ++c) light.colour[c] += lamp.share[s].weight * lamp.light.intensity[c];
    }
  }
  for (std::uint32_t i = 0; i < level.count; ++i) {
    SectorLights& lights = level.resident.get()[i]->lights;
    if (!lights.is_changed) continue;
    for (std::uint32_t l = 0; l < lights.count; ++l) {
      VirtualLight& light = lights.light.get()[l];
      const VirtualLight& first = lightAt(table, light.first);
      if (first.touched != 0 && &first != &light) std::copy_n(first.colour, 3, light.colour);
    }
  }
}

/// Computes the local light of the sectors whose lights were touched.
void lightChanged(WelkinLevel& level, WelkinLightsResult& result) {
  for (std::uint32_t i = 0; i < level.count; ++i) {
    WelkinSector& sector = *level.resident.get()[i];
    if (!sector.lights.is_changed) continue;
    sector.lights.is_changed = false;
    for (std::uint32_t l = 0; l < sector.lights.count; ++l) sector.lights.light.get()[l].touched = 0;
    lightLocally(sector);
    ++result.sectors;
    result.probes += sector.probes;
  }
}

}  // namespace

bool openLamps(const core::HostMemory& memory, std::uint32_t capacity, Lamps& lamps) {
  lamps.capacity = capacity;
  return lamps.lamp.allocate(memory, capacity);
}

void lightsCome(WelkinLevel& level, WelkinSector& sector) {
  if (sector.lights.count == 0) return;
  linkLights(level.lights, sector);
  renameShares(level, sector.lights);
  bool is_coloured = false;
  for (std::uint32_t l = 0; l < sector.lights.count; ++l)
    for (const float c : sector.lights.light.get()[l].colour) is_coloured = is_coloured || c > 0.0F;
  if (is_coloured || sector.lights.is_lit) lightLocally(sector);
}

void lightsLeave(WelkinLevel& level, WelkinSector& sector) {
  if (sector.lights.count == 0) return;
  unlinkLights(level.lights, sector);
  renameShares(level, sector.lights);
  releaseNumber(level.lights, sector);
}

}  // namespace welkin::probes

using namespace welkin::core;
using namespace welkin::probes;

WelkinResult welkin_level_set_lights(WelkinLevel* level, uint32_t count, const WelkinPointLight* lights,
                                     WelkinSees sees, void* user, WelkinLightsResult* result) {
  if (const auto r = nonNull(__func__, {{"level", level}})) return r;
  if (result != nullptr)
    if (const auto r = sized(__func__, "result", result)) return r;
  Lamps& lamps = level->lamps;
  if (count > lamps.capacity)
    return refuse(__func__, "count is %u, must be at most the level's %u (WelkinLevelLimits::light_capacity)", count,
                  lamps.capacity);
  if (count > 0 && lights == nullptr) return refuse(__func__, "lights is null");
  for (std::uint32_t i = 0; i < count; ++i)
    if (const auto r = checkLamp(__func__, i, lights[i])) return r;
  if (level->piece_count != 0) return refuse(__func__, "a relighting has begun and must end first");
  const bool is_new_test = sees != lamps.sees;
  lamps.sees = sees;
  WelkinLightsResult out{};
  for (std::uint32_t i = 0; i < std::max(count, lamps.count); ++i) {
    Lamp& lamp = lamps.lamp.get()[i];
    if (i >= count) {
      touchLights(level->lights, lamp);
      continue;
    }
    if (i >= lamps.count) lamp = Lamp{};
    if (i >= lamps.count || is_new_test) lamp.is_stale = 1;
    out.shared += update(level->lights, {sees, user}, lamp, lights[i]) ? 1U : 0U;
    out.unseen += lamp.shares == 0 ? 1U : 0U;
  }
  lamps.count = count;
  colourLights(*level);
  lightChanged(*level, out);
  if (result != nullptr) give(out, result);
  return WELKIN_OK;
}
