// SPDX-License-Identifier: Apache-2.0
// The probes of a place whose eight cells no wall parts: most places. Those beside walls are for format::probesAbout.
#pragma once

#include "format/cut_lookup.h"
#include "probes/look_up.h"

namespace welkin::probes {

/// A place in cells from the corner of a sector and the bottom of its grid.
struct PlaceInCells {
  double x, y, z;
};

inline PlaceInCells inCells(const WelkinSector& sector, double x, double y, double z) {
  constexpr double kCell_m = format::kCellWidth_m;
  return {(x - kSector_m * sector.x) / kCell_m, (y - sector.grid.low_y) / sector.grid.cell_height_m,
          (z - kSector_m * sector.z) / kCell_m};
}

/// The bits of the 16 cells along x of a row, of a sector with cuts.
inline unsigned cutRow(const WelkinSector& sector, int y, int z) {
  const auto row = static_cast<unsigned>(y + format::kCellsAcross * z);
  return static_cast<unsigned>(sector.cut.get()[row / 4] >> (row % 4 * 16)) & 0xffffU;
}

/// Weights of four cells of one z: by x, then y.
inline Directions sharesOf(float x, float y, float z) {
  const float low_x = 1.0F - x, low_y = (1.0F - y) * z, high_y = y * z;
  return Directions{low_x * low_y, x * low_y, low_x * high_y, x * high_y};
}

/// Divides the weights by their sum. The probes serve the place if that is more than 0.
inline void normalise(const Directions& low, const Directions& high, PointProbes& out) {
  const Directions both = low + high;
  const float total = (both[0] + both[1]) + (both[2] + both[3]);
  out.serve = total > 0.0F;
  const float inverse = out.serve ? 1.0F / total : 0.0F;
  out.weight[0] = low * inverse;
  out.weight[1] = high * inverse;
}

/// The probes of a place whose eight cells lie in the grid of one sector without rooms. False if it is no such place or
/// a wall parts one of the cells.
inline bool innerProbes(const WelkinSector& sector, const PlaceInCells& place, PointProbes& out) {
  constexpr int kAcross = format::kCellsAcross;
  constexpr double kEnd = kAcross - 1;
  const double low_x = place.x - 0.5, low_y = place.y - 0.5, low_z = place.z - 0.5;
  if (!(low_x >= 0.0 && low_x < kEnd && low_y >= 0.0 && low_y < kEnd && low_z >= 0.0 && low_z < kEnd) ||
      sector.has_rooms || sector.probes == 0)
    return false;
  const int x = static_cast<int>(low_x), y = static_cast<int>(low_y), z = static_cast<int>(low_z);
  if (sector.cut.get() != nullptr) {
    const unsigned cuts =
        cutRow(sector, y, z) | cutRow(sector, y + 1, z) | cutRow(sector, y, z + 1) | cutRow(sector, y + 1, z + 1);
    if ((cuts >> x & 3U) != 0) return false;
  }
  const auto in_x = static_cast<float>(low_x - x), in_y = static_cast<float>(low_y - y);
  const auto in_z = static_cast<float>(low_z - z);
  const std::uint8_t* grid = sector.grid.grid.data() + (x + kAcross * (y + kAcross * z));
  using Ints [[gnu::vector_size(sizeof(Directions))]] = std::int32_t;
  Directions weight[2] = {sharesOf(in_x, in_y, 1.0F - in_z), sharesOf(in_x, in_y, in_z)};
  for (int half = 0; half < 2; ++half) {
    const std::uint8_t* g = grid + kAcross * kAcross * half;
    const std::size_t probe[4] = {g[0], g[1], g[kAcross], g[kAcross + 1]};
    const Ints name = {g[0], g[1], g[kAcross], g[kAcross + 1]};
    const Ints is_there = name != format::kNoProbe;
    weight[half] = reinterpret_cast<Directions>(reinterpret_cast<Ints>(weight[half]) & is_there);
    for (int i = 0; i < 4; ++i) {
      const std::size_t at = probe[i] == format::kNoProbe ? 0 : probe[i];
      out.light[4 * half + i] = sector.light.get() + kColours * at;
    }
  }
  normalise(weight[0], weight[1], out);
  return true;
}

/// Likewise of any place over the sector `home`, whose cells may lie in others or in none, and within rooms. False if a
/// wall parts one of the cells.
bool openProbes(const WelkinLevel& level, const WelkinSector& home, const format::InWorld& place, PointProbes& out);

/// Whether no wall parts a cell of the box that two places span, at most two cells an axis, in the sector's grid.
inline bool isOpen(const WelkinSector& sector, const PlaceInCells& a, const PlaceInCells& b) {
  constexpr double kEnd = format::kCellsAcross;
  if (!(std::min(a.x, b.x) >= 0.0 && std::max(a.x, b.x) < kEnd && std::min(a.z, b.z) >= 0.0 &&
        std::max(a.z, b.z) < kEnd))
    return false;
  if (sector.cut.get() == nullptr) return true;
  if (!(std::min(a.y, b.y) >= 0.0 && std::max(a.y, b.y) < kEnd)) return false;
  const int y = static_cast<int>(a.y), z = static_cast<int>(a.z), to_y = static_cast<int>(b.y),
            to_z = static_cast<int>(b.z);
  const unsigned cuts =
      cutRow(sector, y, z) | cutRow(sector, to_y, z) | cutRow(sector, y, to_z) | cutRow(sector, to_y, to_z);
  return (cuts & (1U << static_cast<int>(a.x) | 1U << static_cast<int>(b.x))) == 0;
}

}  // namespace welkin::probes
