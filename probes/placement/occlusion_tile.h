// SPDX-License-Identifier: Apache-2.0
// What vegetation beyond the probe volume gets instead: a sector's sky visibility from above.
#pragma once

#include <optional>
#include <vector>

#include "probes/sector.h"

namespace welkin::probes {

/// From above, cell x + kCells z of kCell_m: sky visibility in [0, 1] of the probe that serves what is seen there, and
/// its height, with which the effect fades. A tile per sector after the talk (slides 57-58).
struct OcclusionTile {
  std::array<double, std::size_t{kCells} * kCells> sky_visibility{};
  std::array<double, std::size_t{kCells} * kCells> probe_y{};
};

/// `sky_visibility`: one a probe. A cell that names no probe takes after the nearest that does (in cells, then by
/// index); nothing for a sector without any.
std::optional<OcclusionTile> computeOcclusionTile(const PlacedSector& sector,
                                                  const std::vector<double>& sky_visibility);

}  // namespace welkin::probes
