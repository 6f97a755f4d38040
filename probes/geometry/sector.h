// SPDX-License-Identifier: Apache-2.0
// Sectors: the squares of a level that are baked, shipped and loaded on their own.
#pragma once

#include <array>
#include <cmath>
#include <compare>
#include <cstdint>
#include <vector>

#include "shared.h"

namespace welkin::geometry {

using f64::Number3;

inline constexpr double kSector_m = 64.0;
inline constexpr int kCells = 16;  ///< of the grid, on each axis
inline constexpr double kCell_m = kSector_m / kCells;
inline constexpr std::size_t kMostProbes = 255;  ///< of a sector
inline constexpr std::uint8_t kNoProbe = 255;    ///< of a cell
inline constexpr std::size_t kMostRooms = 254;   ///< of a sector

/// The square floor(x / 64 m), floor(z / 64 m).
struct SectorId {
  int x = 0;
  int z = 0;
  auto operator<=>(const SectorId&) const = default;
};

/// An axis-aligned box, metres; its faces belong to it.
struct Box {
  Number3 low;
  Number3 high;
  friend bool operator==(const Box& a, const Box& b) { return a.low == b.low && a.high == b.high; }
};

inline bool contains(const Box& box, const Number3& p) {
  return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y && p.z >= box.low.z &&
         p.z <= box.high.z;
}

struct Probe {
  Number3 position;
};

/// A box whose inside has probes of its own: what is in it is lit by none from outside, and the other way round. A
/// position in several belongs to the first.
struct Room {
  Box box;                        ///< as float32 in a sector's file
  std::uint8_t probe = kNoProbe;  ///< the room's nearest to the middle of its part of the sector, or kNoProbe
};

/// What placement makes of a sector.
struct PlacedSector {
  SectorId id;
  std::vector<Probe> probe;        ///< at most kMostProbes
  double low_y = 0.0;              ///< bottom of the grid, metres
  double cell_height_m = kCell_m;  ///< larger where the sector is higher than kSector_m
  /// Index of the nearest probe that the cell can see, or kNoProbe: cell x + kCells (y + kCells z).
  std::array<std::uint8_t, kCells * kCells * kCells> grid{};
  /// Index of the probe that serves what is seen from above: cell x + kCells z; kNoProbe only in a sector without any.
  std::array<std::uint8_t, kCells * kCells> top{};
  std::vector<Room> room;             ///< those that touch the sector
  std::vector<std::uint8_t> in_room;  ///< by probe: 0 outside of all, else 1 + index of its room; empty without rooms
};

/// The sector of a position.
inline SectorId sectorAt(const Number3& position) {
  return {static_cast<int>(std::floor(position.x / kSector_m)), static_cast<int>(std::floor(position.z / kSector_m))};
}

}  // namespace welkin::geometry
