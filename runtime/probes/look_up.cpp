// SPDX-License-Identifier: Apache-2.0
#include "probes/look_up.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "probes/open_cells.h"
#include "probes/rooms.h"

namespace welkin::probes {
namespace {

/// The grid of a resident sector, for format::probesAbout.
auto gridsOf(const WelkinLevel& level) {
  return [&level](int x, int z) -> const format::GridView* {
    const WelkinSector* sector = residentAt(level, x, z);
    return sector == nullptr ? nullptr : &sector->grid;
  };
}

/// Whether every cell's place fits into an int.
bool isNear(const format::InWorld& p) {
  constexpr double kFarthest_m = 0x1p30;
  return std::abs(p[0]) < kFarthest_m && std::abs(p[1]) < kFarthest_m && std::abs(p[2]) < kFarthest_m;
}

/// std::floor of a value that an int holds; the library's is slow on older processors.
int floorOf(double v) {
  const int towards_0 = static_cast<int>(v);
  return towards_0 - (v < towards_0 ? 1 : 0);
}

const WelkinSector* sectorAt(const WelkinLevel& level, const format::InWorld& p) {
  return residentAt(level, floorOf(p[0] / kSector_m), floorOf(p[2] / kSector_m));
}

/// The probes of a place beside walls.
void probesBesideWalls(const WelkinLevel& level, const WelkinSector& home, const format::InWorld& p, PointProbes& out) {
  const std::uint32_t room = roomAt(home, p);
  const format::EightProbes about = format::probesAbout(p, gridsOf(level));
  float weight[8] = {};
  std::fill_n(out.light, 8, kDark);
  for (std::size_t i = 0; i < about.count; ++i) {
    const format::WeightedProbe& found = about.probe[i];
    const bool is_home = found.sector_x == home.x && found.sector_z == home.z;
    const WelkinSector& sector = is_home ? home : *residentAt(level, found.sector_x, found.sector_z);
    if (!isInRoom(sector, found.probe, home, room)) continue;
    weight[i] = static_cast<float>(found.weight);
    out.light[i] = sector.light.get() + kColours * found.probe;
  }
  Directions half[2];
  std::memcpy(half, weight, sizeof weight);
  normalise(half[0], half[1], out);
  if (!out.serve) serveFromRoom(home, room, out);
}

PointLight lightOf(const PointProbes& probes) {
  PointLight sum{{}, probes.serve};
  for (int i = 0; i < 8; ++i) {
    const float weight = probes.weight[i / 4][i % 4];
    for (std::size_t c = 0; c < kChannels; ++c) {
      Directions light;
      std::memcpy(&light, probes.light[i] + c * kDirections, sizeof light);
      sum.channel[c] += weight * light;
    }
  }
  return sum;
}

/// The light of a place in a sector, by the probes of its own side of the rooms' faces alone.
PointLight lightOfSide(const WelkinLevel& level, const WelkinSector& home, const format::InWorld& p) {
  PointProbes probes;
  if (!innerProbes(home, inCells(home, p[0], p[1], p[2]), probes) && !openProbes(level, home, p, probes))
    probesBesideWalls(level, home, p, probes);
  return lightOf(probes);
}

/// The light with a share of another. If one is not served, it is the other.
PointLight mixed(const PointLight& light, const PointLight& other, double share) {
  if (!other.is_served) return light;
  if (!light.is_served) return other;
  PointLight sum = light;
  for (std::size_t c = 0; c < kChannels; ++c)
    sum.channel[c] += static_cast<float>(share) * (other.channel[c] - light.channel[c]);
  return sum;
}

}  // namespace

PointLight lightAt(const WelkinLevel& level, const format::InWorld& p) {
  if (!isNear(p)) return {};
  const WelkinSector* home = sectorAt(level, p);
  if (home == nullptr) return {};
  const PointLight light = lightOfSide(level, *home, p);
  if (!home->has_rooms || home->file->door() == nullptr) return light;
  const format::BeyondDoor beyond = beyondDoorOf(*home, p);
  const WelkinSector* there = beyond.share > 0.0 ? sectorAt(level, beyond.place) : nullptr;
  return there == nullptr ? light : mixed(light, lightOfSide(level, *there, beyond.place), beyond.share);
}

PointLight lightOff(const WelkinLevel& level, const format::InWorld& position, const format::InWorld& normal) {
  if (!isNear(position)) return {};
  const auto along = [&](double way_m) {
    return format::InWorld{position[0] + normal[0] * way_m, position[1] + normal[1] * way_m,
                           position[2] + normal[2] * way_m};
  };
  const WelkinSector* home = sectorAt(level, position);
  if (home != nullptr) {
    const format::InWorld end = along(2.0 * kPush_m), place = along(kPush_m);
    if (isOpen(*home, inCells(*home, position[0], position[1], position[2]), inCells(*home, end[0], end[1], end[2]))) {
      PointProbes probes;
      if (innerProbes(*home, inCells(*home, place[0], place[1], place[2]), probes)) return lightOf(probes);
      return lightAt(level, place);
    }
  }
  return lightAt(level, format::pushedPlace(position, normal, kPush_m, gridsOf(level)));
}

}  // namespace welkin::probes
