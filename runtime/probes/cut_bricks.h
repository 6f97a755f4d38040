// SPDX-License-Identifier: Apache-2.0
// The probes of a brick: those of a cell and the 26 about it, as one side of the cell's walls sees them.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "probes/level.h"

namespace welkin::probes {

/// A sector that bricks read.
struct BrickSector {
  const format::GridView* grid;  ///< null: no sector there
  const WelkinSector* sector;
  std::uint32_t number;
};

/// A probe: 256 times its sector's number and its own; kNoBrickProbe: none; kDarkBrickProbe: no light.
using BrickProbe = std::uint32_t;
inline constexpr BrickProbe kNoBrickProbe = ~0U, kDarkBrickProbe = ~1U;

/// In the order of the bits of format::openBit.
using BrickProbes = std::array<BrickProbe, 27>;

/// The 3 x 3 sectors about one, and the volume's height of texels.
struct BrickSectors {
  std::array<BrickSector, 9> sector;  ///< x, then z
  std::int32_t x = 0, z = 0;          ///< of the middle one
  double texel_height_m = 4.0;

  const BrickSector& at(int sector_x, int sector_z) const {
    return sector[static_cast<std::size_t>(sector_x - x + 1 + 3 * (sector_z - z + 1))];
  }
};

/// A part of a cell of the middle sector.
struct BrickPart {
  format::CutLeaf leaf;
  std::uint32_t room = 0;  ///< of the sector; 0: outside of all
  format::InWorld p;       ///< a place in the part
};

/// The brick of a part. A cell that must not light it has the probe of one beside it, and in a room that no cell may
/// light, the room's own probe. False if the brick would be the volume's own texels, or no cell may light it.
bool brickOf(const BrickSectors& sectors, const format::CellPlace& cell, const BrickPart& part, BrickProbes& brick);

/// A box in a cell, metres from the sector's corner, and the room that its places are in.
struct RoomPart {
  format::FromCorner low, size;
  std::uint32_t room = 0;
};

/// A place in each leaf of a cut cell's tree, as far from the ends of the leaf and of the part as some samples show.
/// `place[i]` is for the node `tree` + i; those of planes are unspecified.
void placesInLeaves(const WelkinSector& sector, std::size_t tree, const RoomPart& part,
                    std::span<format::FromCorner, format::kMostTreeNodes> place);

}  // namespace welkin::probes
