// SPDX-License-Identifier: Apache-2.0
// A sector's share of the open sky's light from above, for surfaces beyond the probe volume.
#pragma once

#include <optional>

#include "probes/transfer/encoding.h"

namespace welkin::sectors {

/// Tile of a sector seen from above: cell x + kCells z, of size kCell_m. For the probe that serves a cell it stores the
/// share of a uniform sky's light that a horizontal surface has, in [0, 1]: from the sky that it sees, and bounced. A
/// fit moves light between a probe's visibility and its transfer, so visibility alone does not tell it. The tile also
/// stores the probe's height, because the effect fades with height. After Stefanov, GDC 2012 (slides 57-58); one tile
/// per sector.
struct OcclusionTile {
  std::array<double, std::size_t{geometry::kCells} * geometry::kCells> sky_visibility{};
  std::array<double, std::size_t{geometry::kCells} * geometry::kCells> probe_y{};
};

/// The tile of a sector; `top` as in PlacedSector. Nothing for a sector without probes.
std::optional<OcclusionTile> occlusionTileOf(const std::array<std::uint8_t, geometry::kCells * geometry::kCells>& top,
                                             const transfer::SectorProbes& probes);

}  // namespace welkin::sectors
