// SPDX-License-Identifier: Apache-2.0
#include "format/sector_check.h"

#include <cmath>

#include "format/check_parts.h"
#include "format/domain_check.h"
#include "format/doors.h"

namespace welkin::format {

void checkRooms(Check& check, const Sector& sector, std::size_t probes) {
  constexpr const char* kName = "the rooms";
  const auto in_room = spanOf(sector.in_room());
  const auto* rooms = sector.room();
  if (rooms == nullptr || rooms->size() == 0) {
    check.that(in_room.empty(), kName, "must be there where a probe is in one");
    return;
  }
  if (!check.that(rooms->size() <= kMostRooms, kName, "must be at most 254") ||
      !check.that(in_room.size() == probes &&
                      std::all_of(in_room.begin(), in_room.end(), [=](std::uint8_t r) { return r <= rooms->size(); }),
                  kName, "must say for every probe whether it is in one of them") ||
      !check.that(reinterpret_cast<std::uintptr_t>(rooms->Data()) % alignof(Room) == 0, kName, "are misaligned"))
    return;
  std::uint8_t number = 0;
  for (const Room* r : *rooms) {
    ++number;
    for (const auto& [low, high] :
         {std::pair(r->low_x(), r->high_x()), std::pair(r->low_y(), r->high_y()), std::pair(r->low_z(), r->high_z())})
      check.that(within(double{low}, -kFarthest_m, kFarthest_m) && within(double{high}, double{low}, kFarthest_m),
                 kName, "must be boxes within 10000 km");
    check.that(r->probe() == kNoProbe || (r->probe() < probes && in_room[r->probe()] == number), kName,
               "must name a probe of their own");
  }
}

void checkDoors(Check& check, const Sector& sector) {
  constexpr const char* kName = "the doors";
  const auto* doors = sector.door();
  const std::size_t rooms = sector.room() == nullptr ? 0 : sector.room()->size();
  if (!check.that(doors->size() >= 1 && doors->size() <= kMostDoors, kName,
                  "must be at most 254, and absent without") ||
      !check.that(reinterpret_cast<std::uintptr_t>(doors->Data()) % alignof(Door) == 0, kName, "are misaligned"))
    return;
  for (const Door* d : *doors) {
    if (!check.that(d->room() < rooms, kName, "must be of a room of the sector")) return;
    for (const float number : {d->low_x(), d->low_y(), d->low_z(), d->high_x(), d->high_y(), d->high_z()})
      if (!check.that(within(double{number}, -kFarthest_m, kFarthest_m), kName, "must be within 10000 km")) return;
    check.that(doorWayOf(boxOf(*d, *sector.room()->Get(d->room()))).is_door, kName,
               "must cross one face of their rooms");
  }
}

void checkPlacement(Check& check, const Placement& placement) {
  constexpr auto kName = "the named places";
  const auto* named = placement.named();
  if (named == nullptr || named->size() == 0) return;
  if (!check.that(named->size() <= kMostNamedPlaces, kName, "must be at most 32") ||
      !check.that(reinterpret_cast<std::uintptr_t>(named->Data()) % alignof(NamedPlace) == 0, kName, "are misaligned"))
    return;
  for (const NamedPlace* n : *named) {
    const std::array<double, 3> position{n->x(), n->y(), n->z()};
    check.that(within(std::span<const double>(position), -kFarthest_m, kFarthest_m), kName, "must be within 10000 km");
    check.that(n->kind() <= PlaceKind::MAX, kName, "must be of a kind");
    check.that(n->kind() == PlaceKind::moved ? within(n->moved_m(), 0.0, kFarthest_m) : n->moved_m() == 0.0, kName,
               "must have moved where they say so, and only there");
  }
}

Fault sectorFaultOf(const File& file) {
  Check check;
  const auto* sector = file.sector();
  if (!check.that(sector != nullptr, "sector", "is missing") ||
      !check.that(sector->probes() != nullptr, "the probes", "are missing") ||
      !check.that(sector->baked_from() != nullptr, "the hash of what it was baked from", "is missing"))
    return check.fault;
  check.that(file.settings() != nullptr, "settings", "are missing");
  check.that(isPlace(sector->x(), sector->z()), "the sector", "must be -15625 to 15625 on each axis");
  check.that(sector->sun() <= SunTransfer::MAX, "sun", "must be none, sh or directional");
  check.that(within(sector->low_y(), -kFarthest_m, kFarthest_m) && within(sector->cell_height_m(), 1e-3, kFarthest_m),
             "the grid", "has a height out of its domain");
  checkProbes(check, *sector->probes(), sector->sun());
  if (check.fault.what != nullptr) return check.fault;
  const auto grid = spanOf(sector->grid());
  const std::uint32_t probes = probesOf(*sector);
  check.that(grid.size() == kGridCells, "the grid", "must have 4096 cells");
  check.that(std::all_of(grid.begin(), grid.end(), [=](std::uint8_t c) { return c == kNoProbe || c < probes; }),
             "the grid", "names a probe that is not there");
  const auto top = spanOf(sector->top());
  check.that(
      top.size() == kTopCells &&
          std::all_of(top.begin(), top.end(), [=](std::uint8_t c) { return probes == 0 ? c == kNoProbe : c < probes; }),
      "the view from above", "must name a probe for each of 256 cells");
  checkRooms(check, *sector, probes);
  if (check.fault.what == nullptr && sector->door() != nullptr) checkDoors(check, *sector);
  if (sector->placement() != nullptr) checkPlacement(check, *sector->placement());
  check.that(sector->unlit() <= probes, "the unlit probes", "must be at most all");
  if (sector->error() != nullptr) checkError(check, *sector->error(), probes);
  if (sector->local() != nullptr) checkLocal(check, *sector->local(), probes);
  if (sector->cuts() != nullptr) checkCuts(check, *sector->cuts(), probes);
  return check.fault;
}

}  // namespace welkin::format
