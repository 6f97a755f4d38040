// SPDX-License-Identifier: Apache-2.0
#include "probes/open_cells.h"

#include <algorithm>
#include <cmath>

#include "probes/rooms.h"

namespace welkin::probes {
namespace {

/// Row of a sector's grid for a height, or -1.
int gridRowAt(const WelkinSector& sector, double y) {
  const double row = std::floor((y - sector.grid.low_y) / sector.grid.cell_height_m);
  return row >= 0.0 && row < format::kCellsAcross ? static_cast<int>(row) : -1;
}

}  // namespace

bool openProbes(const WelkinLevel& level, const WelkinSector& home, const format::InWorld& place, PointProbes& out) {
  constexpr int kAcross = format::kCellsAcross;
  constexpr double kFarthest = 1e6;  // rows
  const PlaceInCells at = inCells(home, place[0], place[1], place[2]);
  if (!(std::abs(at.y) < kFarthest)) return false;
  const std::uint32_t room = roomAt(home, place);
  const double low_x = std::floor(at.x - 0.5), low_y = std::floor(at.y - 0.5), low_z = std::floor(at.z - 0.5);
  const auto in_x = static_cast<float>(at.x - 0.5 - low_x), in_y = static_cast<float>(at.y - 0.5 - low_y);
  const auto in_z = static_cast<float>(at.z - 0.5 - low_z);
  const Directions share[2] = {sharesOf(in_x, in_y, 1.0F - in_z), sharesOf(in_x, in_y, in_z)};
  Directions weight[2] = {};
  std::fill_n(out.light, 8, kDark);
  for (int column = 0; column < 4; ++column) {
    const int dx = column & 1, dz = column >> 1;
    const int x = static_cast<int>(low_x) + dx, z = static_cast<int>(low_z) + dz;
    const auto beyond = [](int cell) { return cell < 0 ? -1 : cell < kAcross ? 0 : 1; };
    const bool is_home = beyond(x) == 0 && beyond(z) == 0;
    const WelkinSector* sector = is_home ? &home : residentAt(level, home.x + beyond(x), home.z + beyond(z));
    if (sector == nullptr) continue;
    for (int dy = 0; dy < 2; ++dy) {
      const double own_row = low_y + dy;
      const double middle_y = home.grid.low_y + (own_row + 0.5) * home.grid.cell_height_m;
      const int row = !is_home                                      ? gridRowAt(*sector, middle_y)
                      : own_row >= 0.0 && own_row < double{kAcross} ? static_cast<int>(own_row)
                                                                    : -1;
      if (row < 0) continue;
      const int in_row = x & (kAcross - 1), layer = z & (kAcross - 1);
      if (sector->cut.get() != nullptr && (cutRow(*sector, row, layer) >> in_row & 1U) != 0) return false;
      const auto cell = static_cast<std::size_t>(in_row + kAcross * (row + kAcross * layer));
      const std::uint8_t probe = sector->grid.grid[cell];
      if (probe == format::kNoProbe || !isInRoom(*sector, probe, home, room)) continue;
      out.light[dx + 2 * dy + 4 * dz] = sector->light.get() + kColours * probe;
      weight[dz][dx + 2 * dy] = share[dz][dx + 2 * dy];
    }
  }
  normalise(weight[0], weight[1], out);
  if (!out.serve) serveFromRoom(home, room, out);
  return true;
}

}  // namespace welkin::probes
