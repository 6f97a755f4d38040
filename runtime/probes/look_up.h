// SPDX-License-Identifier: Apache-2.0
// Which probes light a point, and by how much: the grid's eight cells about it, without those behind walls or of other
// rooms.
#pragma once

#include <array>

#include "probes/level.h"

namespace welkin::probes {

/// A probe's share of a point's light. The shares of a point sum to 1.
struct ProbeShare {
  const float* light;  ///< of the probe: [channel][direction]
  float weight;
};

/// The probes of a point, at most eight.
struct PointProbes {
  std::array<ProbeShare, 8> share;
  std::size_t count = 0;
};

/// The probes for a place, metres, as pushedOff gives it.
PointProbes probesFor(const WelkinLevel& level, const format::InWorld& place);

/// The place from where a point of a surface with a unit normal looks up its light (format::pushedPlace).
format::InWorld pushedOff(const WelkinLevel& level, const format::InWorld& position, const format::InWorld& normal);

/// The light at a point: [channel][direction]; 0 without probes.
void addLight(const PointProbes& probes, float* out);

}  // namespace welkin::probes
