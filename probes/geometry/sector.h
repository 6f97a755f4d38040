// SPDX-License-Identifier: Apache-2.0
// Sectors are the squares of a level that are baked, shipped and loaded separately.
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
inline constexpr int kCells = 16;  ///< cells of the grid on each axis
inline constexpr double kCell_m = kSector_m / kCells;
inline constexpr std::size_t kMostProbes = 255;  ///< limit for one sector
inline constexpr std::uint8_t kNoProbe = 255;    ///< entry of a cell without a probe
inline constexpr std::size_t kMostRooms = 254;   ///< limit for one sector
inline constexpr std::size_t kMostDoors = 254;   ///< limit for one sector

/// The square floor(x / 64 m), floor(z / 64 m).
struct SectorId {
  int x = 0;
  int z = 0;
  auto operator<=>(const SectorId&) const = default;
};

/// An axis-aligned box, metres. The faces belong to the box.
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

/// A box with probes of its own inside. Probes outside never light the inside, and probes inside never light the
/// outside. A position in several rooms belongs to the first.
struct Room {
  Box box;                        ///< stored as float32 from the sector's corner in a sector's file
  std::uint8_t probe = kNoProbe;  ///< its probe nearest to the middle of its part of the sector, or kNoProbe
};

/// A box across one face of a room, in which light goes over smoothly from one side of the face to the other.
struct Door {
  Box box;                ///< stored as float32 from the sector's corner in a sector's file
  std::uint8_t room = 0;  ///< index of its room in the sector
};

/// The cells of a sector, each with its probe, and the rooms.
struct SectorGrid {
  double low_y = 0.0;              ///< bottom of the grid, metres
  double cell_height_m = kCell_m;  ///< larger if the sector is higher than kSector_m
  /// Index of the nearest probe that the cell can see, or kNoProbe: cell x + kCells (y + kCells z).
  std::array<std::uint8_t, kCells * kCells * kCells> grid{};
  /// Index of the probe for surfaces that are seen from above: cell x + kCells z. kNoProbe occurs only in a sector
  /// without probes.
  std::array<std::uint8_t, kCells * kCells> top{};
  std::vector<Room> room;             ///< rooms that touch the sector
  std::vector<std::uint8_t> in_room;  ///< by probe: 0 outside rooms, else 1 + index of its room; empty without rooms
  std::vector<Door> door;             ///< doors that touch the sector; a position in several has the first
};

/// A sector after placement.
struct PlacedSector : SectorGrid {
  SectorId id;
  std::vector<Probe> probe;  ///< at most kMostProbes
};

/// The sector's corner of least x and z, at height 0. A sector is baked as if this were the world's origin.
inline Number3 cornerOf(SectorId id) {
  return {kSector_m * id.x, 0.0, kSector_m * id.z};
}

/// The sector that contains a position.
inline SectorId sectorAt(const Number3& position) {
  return {static_cast<int>(std::floor(position.x / kSector_m)), static_cast<int>(std::floor(position.z / kSector_m))};
}

}  // namespace welkin::geometry
