// SPDX-License-Identifier: Apache-2.0
// What vegetation beyond the probe volume gets instead: a sector's sky visibility from above.
#pragma once

#include <optional>

#include "probes/transfer/encoding.h"

namespace welkin::sectors {

/// From above, cell x + kCells z of kCell_m: of the probe that serves what is seen there the share of a uniform sky
/// that a level surface sees, in [0, 1], and the probe's height, with which the effect fades. A tile a sector, after
/// the talk (slides 57-58).
struct OcclusionTile {
  std::array<double, std::size_t{geometry::kCells} * geometry::kCells> sky_visibility{};
  std::array<double, std::size_t{geometry::kCells} * geometry::kCells> probe_y{};
};

/// `top` as PlacedSector has it. Nothing for a sector without probes.
std::optional<OcclusionTile> occlusionTileOf(const std::array<std::uint8_t, geometry::kCells * geometry::kCells>& top,
                                             const transfer::SectorProbes& probes);

}  // namespace welkin::sectors
