// SPDX-License-Identifier: Apache-2.0
// Places sectors of small levels for tests.
#pragma once

#include <algorithm>

#include "probes/placement/placement.h"
#include "tests/probes/rooms.h"

namespace welkin::tests {

using geometry::PlacedSector;
using geometry::Probe;
using geometry::SectorId;
using geometry::Surfaces;
using placement::PlacementReport;
using placement::PlacementSettings;

inline PlacedSector place(const Surfaces& s, const SectorId& id, const PlacementSettings& settings = {},
                          PlacementReport* report = nullptr) {
  const geometry::Tracer tracer(s);
  PlacementReport unused;
  return placeSector(tracer, id, settings, report != nullptr ? *report : unused);
}

/// Number of probes whose height is between the two.
inline std::size_t countBetween(const PlacedSector& sector, double low_y, double high_y) {
  return static_cast<std::size_t>(std::count_if(sector.probe.begin(), sector.probe.end(), [&](const Probe& p) {
    return p.position.y > low_y && p.position.y < high_y;
  }));
}

}  // namespace welkin::tests
