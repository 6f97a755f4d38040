// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/rooms.h"

#include <fmt/format.h>

#include <algorithm>

#include "probes/geometry/reach.h"
#include "probes/placement/validity.h"
#include "sky/base/error.h"

namespace welkin::placement {

using f64::Number3;
namespace {

/// Middle of the box's part of the sector.
Number3 middleOf(const geometry::Box& box, const geometry::Column& square) {
  return {0.5 * (std::max(box.low.x, square.low_x) + std::min(box.high.x, square.high_x)),
          0.5 * (box.low.y + box.high.y),
          0.5 * (std::max(box.low.z, square.low_z) + std::min(box.high.z, square.high_z))};
}

bool touches(const geometry::Column& square, const geometry::Box& box) {
  return square.touches(box.low.x, box.high.x, box.low.z, box.high.z);
}

/// Whether a door of a room reaches into the sector.
bool hasDoorIn(const PlacementSettings& settings, const geometry::Box& room, const geometry::Column& square) {
  return std::any_of(settings.door.begin(), settings.door.end(),
                     [&](const RoomDoor& door) { return door.room == room && touches(square, door.box); });
}

void setDoors(const PlacementSettings& settings, const geometry::Column& square, geometry::PlacedSector& sector) {
  sector.door.clear();
  for (const RoomDoor& door : settings.door) {
    const auto of_box = [&](const geometry::Room& room) { return room.box == door.room; };
    const auto room = std::find_if(sector.room.begin(), sector.room.end(), of_box);
    if (room == sector.room.end() || !touches(square, door.box)) continue;
    if (sector.door.size() == geometry::kMostDoors)
      throw base::Error(base::ExitStatus::content,
                        fmt::format("[[room]] doors: more than {} touch sector {}_{}; at most {} may",
                                    geometry::kMostDoors, sector.id.x, sector.id.z, geometry::kMostDoors));
    sector.door.push_back({door.box, static_cast<std::uint8_t>(room - sector.room.begin())});
  }
}

}  // namespace

void setRooms(const PlacementSettings& settings, geometry::PlacedSector& sector) {
  const geometry::Column square = geometry::columnOf(sector.id, 0.0);
  std::vector<std::size_t> room_of;
  for (const geometry::Probe& p : sector.probe) room_of.push_back(roomOf(settings, p.position));
  std::vector<std::uint8_t> in_room(sector.probe.size(), 0);
  sector.room.clear();
  for (std::size_t r = 0; r < settings.room.size(); ++r) {
    const geometry::Box& box = settings.room[r];
    if (!touches(square, box) && !hasDoorIn(settings, box, square)) continue;
    if (sector.room.size() == geometry::kMostRooms)
      throw base::Error(base::ExitStatus::content,
                        fmt::format("[[room]]: more than {} touch sector {}_{}; at most {} may", geometry::kMostRooms,
                                    sector.id.x, sector.id.z, geometry::kMostRooms));
    geometry::Room& room = sector.room.emplace_back(geometry::Room{box});
    const Number3 middle = middleOf(box, square);
    double nearest_m = 0.0;
    for (std::size_t i = 0; i < room_of.size(); ++i) {
      if (room_of[i] != r + 1) continue;
      in_room[i] = static_cast<std::uint8_t>(sector.room.size());
      const double distance_m = distanceOf(middle, sector.probe[i].position);
      if (room.probe != geometry::kNoProbe && distance_m >= nearest_m) continue;
      room.probe = static_cast<std::uint8_t>(i);
      nearest_m = distance_m;
    }
  }
  setDoors(settings, square, sector);
  sector.in_room = sector.room.empty() ? std::vector<std::uint8_t>() : std::move(in_room);
}

}  // namespace welkin::placement
