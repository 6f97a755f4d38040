// SPDX-License-Identifier: Apache-2.0
#include "probes/rooms.h"

#include <algorithm>
#include <cmath>

#include "format/domain_check.h"

namespace welkin::probes {
namespace {

/// Whether two boxes are one that two sectors have stored, each as floats from its own corner.
bool isSameRoom(const RoomBox& a, const RoomBox& b) {
  constexpr double kFloats = 0x1p-22;  // twice the rounding of a float
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double from_corner =
        axis == 1 ? std::max(std::abs(a.low[1]), std::abs(a.high[1])) : kSector_m + a.high[axis] - a.low[axis];
    if (std::abs(a.low[axis] - b.low[axis]) > kFloats * from_corner) return false;
    if (std::abs(a.high[axis] - b.high[axis]) > kFloats * from_corner) return false;
  }
  return true;
}

}  // namespace

RoomBox roomBox(const WelkinSector& sector, std::uint32_t number) {
  const format::Room& room = *sector.file->room()->Get(number - 1);
  const double x = kSector_m * sector.x, z = kSector_m * sector.z;
  return {{double{room.low_x()} + x, double{room.low_y()}, double{room.low_z()} + z},
          {double{room.high_x()} + x, double{room.high_y()}, double{room.high_z()} + z}};
}

std::uint32_t roomAt(const WelkinSector& sector, const format::InWorld& p) {
  for (std::uint32_t number = 1; number <= roomsOf(sector); ++number) {
    const RoomBox box = roomBox(sector, number);
    bool inside = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
      inside = inside && p[axis] >= box.low[axis] && p[axis] <= box.high[axis];
    if (inside) return number;
  }
  return 0;
}

format::BeyondDoor beyondDoorOf(const WelkinSector& sector, const format::InWorld& p) {
  const format::InWorld corner{kSector_m * sector.x, 0.0, kSector_m * sector.z};
  const format::InWorld from{p[0] - corner[0], p[1], p[2] - corner[2]};
  for (const format::Door* door : *sector.file->door()) {
    const format::DoorBox box = format::boxOf(*door, *sector.file->room()->Get(door->room()));
    const auto isWithin = [&](std::size_t a) { return from[a] >= box.low[a] && from[a] <= box.high[a]; };
    if (!isWithin(0) || !isWithin(1) || !isWithin(2)) continue;
    format::BeyondDoor beyond = format::beyondDoor(format::doorWayOf(box), from);
    if (!(beyond.share > 0.0)) continue;
    for (std::size_t a = 0; a < 3; ++a) beyond.place[a] += corner[a];
    return beyond;
  }
  return {};
}

bool isInRoom(const WelkinSector& sector, std::uint8_t probe, const WelkinSector& home, std::uint32_t number) {
  if (!sector.has_rooms && number == 0) return true;
  const auto in_room = format::spanOf(sector.file->in_room());
  const std::uint32_t own = in_room.empty() ? 0 : in_room[probe];
  if (own == 0 || number == 0 || &sector == &home) return own == number;
  return isSameRoom(roomBox(sector, own), roomBox(home, number));
}

void serveFromRoom(const WelkinSector& home, std::uint32_t number, PointProbes& out) {
  const std::uint8_t probe = number == 0 ? format::kNoProbe : home.file->room()->Get(number - 1)->probe();
  if (probe == format::kNoProbe) return;
  out.light[0] = home.light.get() + kColours * probe;
  out.weight[0][0] = 1.0F;
  out.serve = true;
}

}  // namespace welkin::probes
