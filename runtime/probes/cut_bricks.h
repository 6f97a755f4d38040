// SPDX-License-Identifier: Apache-2.0
// The probes of a brick: those of a cell and the 26 about it, as one side of the cell's walls sees them.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "format/cut_lookup.h"
#include "format/sector_check.h"

namespace welkin::probes {

/// A sector that bricks read.
struct BrickSector {
  const format::GridView* grid;                                ///< null: no sector there
  const std::array<std::uint8_t, format::kGridCells>* filled;  ///< the grid, its holes as their nearest cells
  std::uint32_t number;
};

/// A probe: 256 times its sector's number and its own; kNoBrickProbe: none.
using BrickProbe = std::uint32_t;
inline constexpr BrickProbe kNoBrickProbe = ~0U;

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

/// The brick of a part of a cell of the middle sector. `p` is a place in the part. A cell that must not light it has
/// the probe of one beside it. False if the brick would be the volume's own texels, or no cell may light it.
bool brickOf(const BrickSectors& sectors, const format::CellPlace& cell, const format::CutLeaf& leaf,
             const format::InWorld& p, BrickProbes& brick);

/// A place in each leaf of a cut cell's tree, as far from its ends as some samples show. `place[i]` is for the node
/// `tree` + i; those of planes are unspecified.
void placesInLeaves(const format::CellCuts& cuts, std::size_t tree, const format::FromCorner& low, float height_m,
                    std::span<format::FromCorner, format::kMostTreeNodes> place);

}  // namespace welkin::probes
