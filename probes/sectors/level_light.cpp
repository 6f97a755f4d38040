// SPDX-License-Identifier: Apache-2.0
#include "probes/sectors/level_light.h"

#include <algorithm>
#include <cmath>

#include "probes/placement/settings.h"
#include "sky/model/projection.h"

namespace welkin::sectors {
namespace {

transfer::LightAt lightAt(const model::Light& light, double time_h) {
  return {light.path.directionAt(time_h), light.normalIrradianceAt(time_h)};
}

/// Adds `factor` times a probe's irradiance for a normal.
void add(const transfer::ProbeIrradiance& probe, const Number3& normal, double factor, LevelIrradiance& sum) {
  const auto weight = transfer::shadingWeights(normal);
  for (std::size_t b = 0; b < transfer::kDirections; ++b) {
    sum.sky += probe.sky[b] * (factor * weight[b]);
    sum.sun_bounce += probe.sun_bounce[b] * (factor * weight[b]);
    sum.local += probe.local[b] * (factor * weight[b]);
  }
}

LevelIrradiance positive(const LevelIrradiance& e) {
  const auto clamped = [](const Number3& v) {
    return Number3(std::max(v.x, 0.0), std::max(v.y, 0.0), std::max(v.z, 0.0));
  };
  return {clamped(e.sky), clamped(e.sun_bounce), clamped(e.local)};
}

geometry::Box boxInWorld(const SectorFile& file, const geometry::Room& room) {
  const Number3 corner = geometry::cornerOf(file.id);
  return {room.box.low + corner, room.box.high + corner};
}

/// Whether two boxes are one that two sectors have stored, each as floats from its own corner.
bool isSame(const geometry::Box& a, const geometry::Box& b) {
  constexpr double kFloats = 0x1p-22;  // twice the rounding of a float
  for (int axis = 0; axis < 3; ++axis) {
    const double from_corner =
        axis == 1 ? std::max(std::abs(a.low.y), std::abs(a.high.y)) : geometry::kSector_m + a.high[axis] - a.low[axis];
    if (std::abs(a.low[axis] - b.low[axis]) > kFloats * from_corner) return false;
    if (std::abs(a.high[axis] - b.high[axis]) > kFloats * from_corner) return false;
  }
  return true;
}

/// The sector's room that contains a position, if any.
const geometry::Room* roomAt(const SectorFile& file, const Number3& position) {
  const auto found = std::find_if(file.room.begin(), file.room.end(), [&](const geometry::Room& room) {
    return geometry::contains(boxInWorld(file, room), position);
  });
  return found == file.room.end() ? nullptr : &*found;
}

/// Whether the probe is in the room, or, without a room, outside all rooms. A room has the same box in every sector
/// that it touches, but for the rounding of floats.
bool isIn(const SectorFile& file, std::uint8_t probe, const geometry::Box* room) {
  const std::size_t number = file.in_room.empty() ? 0 : file.in_room[probe];
  return room != nullptr ? number > 0 && isSame(boxInWorld(file, file.room[number - 1]), *room) : number == 0;
}

/// The place beyond a door's face from which a place has some of its light.
format::BeyondDoor beyondDoorOf(const SectorFile& file, const format::InWorld& place) {
  const Number3 corner = geometry::cornerOf(file.id);
  const format::InWorld from{place[0] - corner.x, place[1], place[2] - corner.z};
  for (const geometry::Door& door : file.door) {
    const auto way = format::doorWayOf(placement::doorBoxOf(door.box, file.room[door.room].box));
    format::BeyondDoor beyond = format::beyondDoor(way, from);
    if (!(beyond.share > 0.0)) continue;
    beyond.place[0] += corner.x;
    beyond.place[2] += corner.z;
    return beyond;
  }
  return {};
}

}  // namespace

std::array<Number3, 4> skyShAt(const model::Sky& sky, double time_h) {
  constexpr double kTolerance = 1e-6;
  const model::SkyInstant instant(sky, time_h);
  const auto moments = model::SkyProjector(sky.luminance, 2, kTolerance).project(instant);
  const double saturation = sky.ambient_saturation.at(time_h);
  std::array<Number3, 4> sh{};
  for (std::size_t i = 0; i < sh.size(); ++i)
    sh[i] = det::desaturate(moments.radiance_sh[i] * instant.intensity(), saturation);
  return sh;
}

LightOfDay lightOfDay(const model::Sky& sky, double time_h) {
  return {skyShAt(sky, time_h), lightAt(sky.sun, time_h), sky.moon ? lightAt(*sky.moon, time_h) : transfer::LightAt{}};
}

LevelLight::LevelLight(const std::vector<SectorFile>& sectors, const model::Sky& sky, double time_h,
                       const transfer::RelightScale& scale, transfer::SkyBounce sky_bounce)
    : LevelLight(sectors, lightOfDay(sky, time_h), time_h, scale, sky_bounce) {}

LevelLight::LevelLight(const std::vector<SectorFile>& sectors, const LightOfDay& day, double time_h,
                       const transfer::RelightScale& scale, transfer::SkyBounce sky_bounce) {
  for (const SectorFile& file : sectors) {
    const transfer::SectorProbes probes = transfer::decodedProbes(file.probes, file.id);
    const transfer::Relight light =
        transfer::relightAt(time_h, day.sky_sh, day.sun, day.moon, file.sun, probes.modes, scale, sky_bounce);
    Sector sector{&file, {file.grid, file.low_y, file.cell_height_m, file.cuts.view()}, {}};
    for (std::size_t i = 0; i < probes.transfer.size(); ++i)
      sector.probe.push_back(transfer::relit(
          probes.transfer[i], i < probes.sun.size() ? probes.sun[i] : transfer::SunCoefficients{}, light));
    sector_.emplace(file.id, std::move(sector));
  }
}

LevelIrradiance LevelLight::ofProbe(const geometry::SectorId& sector, std::size_t probe, const Number3& normal) const {
  LevelIrradiance sum;
  add(sector_.at(sector).probe.at(probe), normal, 1.0, sum);
  return positive(sum);
}

const LevelLight::Sector* LevelLight::sectorOf(int x, int z) const {
  const auto found = sector_.find({x, z});
  return found == sector_.end() ? nullptr : &found->second;
}

std::optional<LevelIrradiance> LevelLight::at(const Number3& position, const Number3& normal, double push_m) const {
  const auto gridOf = [&](int x, int z) {
    const Sector* sector = sectorOf(x, z);
    return sector == nullptr ? nullptr : &sector->grid;
  };
  const format::InWorld place =
      format::pushedPlace({position.x, position.y, position.z}, {normal.x, normal.y, normal.z}, push_m, gridOf);
  const auto light = ofSide(place, normal);
  const geometry::SectorId home = geometry::sectorAt(Number3(place[0], place[1], place[2]));
  const Sector* sector = sectorOf(home.x, home.z);
  const format::BeyondDoor beyond = sector == nullptr ? format::BeyondDoor{} : beyondDoorOf(*sector->file, place);
  if (!(beyond.share > 0.0)) return light ? std::optional(positive(*light)) : std::nullopt;
  const auto other = ofSide(beyond.place, normal);
  if (!light && !other) return std::nullopt;
  if (!light || !other) return positive(light ? *light : *other);
  const auto mixed = [&](const Number3& a, const Number3& b) { return a * (1.0 - beyond.share) + b * beyond.share; };
  return positive(
      {mixed(light->sky, other->sky), mixed(light->sun_bounce, other->sun_bounce), mixed(light->local, other->local)});
}

std::optional<LevelIrradiance> LevelLight::ofSide(const format::InWorld& place, const Number3& normal) const {
  const auto gridOf = [&](int x, int z) {
    const Sector* sector = sectorOf(x, z);
    return sector == nullptr ? nullptr : &sector->grid;
  };
  const Number3 p(place[0], place[1], place[2]);
  const geometry::SectorId home_id = geometry::sectorAt(p);
  const Sector* home = sectorOf(home_id.x, home_id.z);
  if (home == nullptr) return std::nullopt;
  const geometry::Room* room = roomAt(*home->file, p);
  const geometry::Box box = room == nullptr ? geometry::Box{} : boxInWorld(*home->file, *room);
  const format::EightProbes probes = format::probesAbout(place, gridOf);
  LevelIrradiance sum;
  double total = 0.0;
  for (std::size_t i = 0; i < probes.count; ++i) {
    const format::WeightedProbe& found = probes.probe[i];
    const Sector& sector = *sectorOf(found.sector_x, found.sector_z);
    if (!isIn(*sector.file, found.probe, room == nullptr ? nullptr : &box)) continue;
    total += found.weight;
    add(sector.probe[found.probe], normal, found.weight, sum);
  }
  if (!(total > 0.0)) {
    if (room == nullptr || room->probe == geometry::kNoProbe) return std::nullopt;
    add(home->probe[room->probe], normal, 1.0, sum);
    return sum;
  }
  sum.sky = sum.sky / total;
  sum.sun_bounce = sum.sun_bounce / total;
  sum.local = sum.local / total;
  return sum;
}

}  // namespace welkin::sectors
