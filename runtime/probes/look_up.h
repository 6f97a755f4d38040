// SPDX-License-Identifier: Apache-2.0
// Which probes light a point, and by how much: the grid's eight cells about it, without those behind walls or of other
// rooms.
#pragma once

#include "probes/level.h"

namespace welkin::probes {

/// A number for each of the four directions, or each of four cells.
using Directions [[gnu::vector_size(kDirections * sizeof(float))]] = float;

inline constexpr float kDark[kColours] = {};  ///< light of a cell without a probe

/// The probes of the eight cells about a point and their weights, which sum to 1.
struct PointProbes {
  Directions weight[2];   ///< of cells by x, then y, then z; 0: the probe does not count
  const float* light[8];  ///< of a probe: [channel][direction]
  bool serve;             ///< false: no probe serves the point, and the weights are 0
};

/// The light at a place.
struct PointLight {
  Directions channel[kChannels];
  bool is_served;
};

/// The light at a place, metres, as format::pushedPlace gives it; 0 where it is not served.
PointLight lightAt(const WelkinLevel& level, const format::InWorld& place);

/// The light for a point of a surface with a unit normal.
PointLight lightOff(const WelkinLevel& level, const format::InWorld& position, const format::InWorld& normal);

}  // namespace welkin::probes
