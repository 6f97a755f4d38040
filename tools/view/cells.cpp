// SPDX-License-Identifier: Apache-2.0
// The cells about a point, and why each does or does not light it.
#include <algorithm>
#include <cmath>
#include <map>

#include "view/answer.h"

namespace welkin::view {
namespace {

using f64::Number3;
using format::CellPart;

constexpr double kPush_m = 1.0;  // as LevelLight::at and the runtime

const char* nameOf(CellPart part) {
  switch (part) {
    case CellPart::lights:
      return "lights";
    case CellPart::no_weight:
      return "too far";
    case CellPart::behind_wall:
      return "behind a wall";
    case CellPart::no_sector:
      return "no sector";
    case CellPart::without_probe:
      return "no probe";
  }
  return "";
}

/// The box of a room in the world.
geometry::Box boxOf(const sectors::SectorFile& file, std::size_t room) {
  const Number3 corner = geometry::cornerOf(file.id);
  return {file.room[room].box.low + corner, file.room[room].box.high + corner};
}

bool isSameBox(const geometry::Box& a, const geometry::Box& b) {
  constexpr double kRounding_m = 1e-3;
  const Number3 low = a.low - b.low, high = a.high - b.high;
  return dot(low, low) + dot(high, high) < kRounding_m * kRounding_m;
}

std::optional<geometry::Box> roomAt(const sectors::SectorFile& file, const Number3& p) {
  for (std::size_t i = 0; i < file.room.size(); ++i)
    if (contains(boxOf(file, i), p)) return boxOf(file, i);
  return std::nullopt;
}

std::optional<geometry::Box> roomOf(const sectors::SectorFile& file, std::size_t probe) {
  if (file.in_room.empty() || file.in_room[probe] == 0) return std::nullopt;
  return boxOf(file, std::size_t{file.in_room[probe]} - 1);
}

bool isSameRoom(const std::optional<geometry::Box>& a, const std::optional<geometry::Box>& b) {
  return a && b ? isSameBox(*a, *b) : !a && !b;
}

}  // namespace

std::size_t cellsAbout(const Level& level, const baked::SurfacePoint& point, std::array<CellOfPoint, 8>& cells) {
  std::map<geometry::SectorId, format::GridView> grids;
  for (const sectors::SectorFile& file : level.sectors())
    grids.emplace(file.id, format::GridView{file.grid, file.low_y, file.cell_height_m, file.cuts.view()});
  const auto gridOf = [&](int x, int z) {
    const auto found = grids.find({x, z});
    return found == grids.end() ? nullptr : &found->second;
  };
  const format::InWorld place = format::pushedPlace({point.position.x, point.position.y, point.position.z},
                                                    {point.normal.x, point.normal.y, point.normal.z}, kPush_m, gridOf);
  const Number3 p(place[0], place[1], place[2]);
  const sectors::SectorFile* home = level.sector(geometry::sectorAt(p));
  if (home == nullptr) return 0;
  const std::optional<geometry::Box> room = roomAt(*home, p);
  std::size_t count = 0;
  double sum = 0.0;
  format::visitCellsAbout(place, gridOf, [&](const format::CellAbout& about) {
    CellOfPoint& cell = cells[count++];
    const Number3 low(format::kCellWidth_m * about.x, home->low_y + home->cell_height_m * about.row,
                      format::kCellWidth_m * about.z);
    cell.box = {low, low + Number3(format::kCellWidth_m, home->cell_height_m, format::kCellWidth_m)};
    cell.weight = about.found.weight;
    cell.part = nameOf(about.part);
    if (about.part != CellPart::lights) return;
    cell.probe = ProbeName{{about.found.sector_x, about.found.sector_z}, about.found.probe};
    if (isSameRoom(room, roomOf(*level.sector(cell.probe->sector), cell.probe->number)))
      sum += cell.share = cell.weight;
    else
      cell.part = "of another room";
  });
  for (std::size_t i = 0; i < count; ++i)
    if (sum > 0.0) cells[i].share /= sum;
  return count;
}

}  // namespace welkin::view
