// SPDX-License-Identifier: Apache-2.0
// Places the probes of a level: above ground, including floors under roofs, above vegetation, and by hand. After
// Stefanov, "Deferred Radiance Transfer Volumes" (GDC 2012), whose probes stand 4 m apart where vertical rays hit.
#pragma once

#include "probes/geometry/tracer.h"
#include "probes/placement/settings.h"
#include "sky/base/progress.h"

namespace welkin::placement {

/// Largest number of sectors of a level: 64 km square.
inline constexpr std::size_t kMostSectors = 1'000'000;

/// Sectors with ground to stand on, vegetation or a probe by hand, each once, in order. Ground counts if a line of the
/// lattice meets it, or if kLeastGround_m2 of it is walkable. A sector whose ground is inside bodies or without
/// headroom gets no probes when it is placed. Throws Error(content) if a setting is out of its range, or for more than
/// kMostSectors, naming the object.
std::vector<geometry::SectorId> sectorsOf(const geometry::Surfaces& surfaces, const PlacementSettings& settings,
                                          const base::Progress& progress = {});

/// Places the probes of a sector and fills its grid and rooms. The result does not depend on results for its
/// neighbours, nor on the number of threads. Probes are ordered: by hand, above ground by lattice (even lines first),
/// above vegetation, then those added so that walkable points see one. `report` is overwritten. Throws as sectorsOf.
geometry::PlacedSector placeSector(const geometry::Tracer& tracer, geometry::SectorId id,
                                   const PlacementSettings& settings, PlacementReport& report,
                                   const base::Progress& progress = {});

/// The probes of placeSector alone, without the cost of the grid. Throws as sectorsOf.
std::vector<geometry::Probe> placeProbes(const geometry::Tracer& tracer, geometry::SectorId id,
                                         const PlacementSettings& settings, const base::Progress& progress = {});

}  // namespace welkin::placement
