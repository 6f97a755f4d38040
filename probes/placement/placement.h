// SPDX-License-Identifier: Apache-2.0
// Where the probes of a level are: above ground, floors under roofs included, above vegetation, and by hand. After the
// "Deferred Radiance Transfer Volumes" of Stefanov (GDC 2012), whose probes stand 4 m apart on hits of vertical rays.
#pragma once

#include "probes/geometry/tracer.h"
#include "probes/placement/checkpoint.h"
#include "probes/placement/settings.h"

namespace welkin::placement {

/// Sectors of a level, at most: 64 km square.
inline constexpr std::size_t kMostSectors = 1'000'000;

/// Sectors with ground to stand on, vegetation or a probe by hand, each once, ordered. Ground: a line of the lattice
/// meets it, or there is kLeastGround_m2 of it to walk on. A sector whose ground turns out to be inside of bodies or
/// without headroom gets no probes when it is placed. Throws Error(content) where a setting is out of its range, and
/// for more than kMostSectors, naming the object.
std::vector<geometry::SectorId> sectorsOf(const geometry::Surfaces& surfaces, const PlacementSettings& settings,
                                          const Checkpoint& checkpoint = {});

/// Places the probes of a sector and fills its grid and rooms; nothing of its neighbours' results takes part, and the
/// result is the same for any number of threads. A report is replaced. Order: by hand, above ground by lattice (even
/// lines first), above vegetation, then those that walkable points needed to see one. Throws as sectorsOf.
geometry::PlacedSector placeSector(const geometry::Tracer& tracer, geometry::SectorId id,
                                   const PlacementSettings& settings, PlacementReport& report,
                                   const Checkpoint& checkpoint = {});

/// The probes of placeSector alone, without the cost of the grid. Throws as sectorsOf.
std::vector<geometry::Probe> placeProbes(const geometry::Tracer& tracer, geometry::SectorId id,
                                         const PlacementSettings& settings, const Checkpoint& checkpoint = {});

}  // namespace welkin::placement
