// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/placement.h"

#include "probes/placement/candidates.h"
#include "probes/placement/column.h"
#include "probes/placement/grid.h"
#include "probes/placement/rooms.h"
#include "probes/placement/selection.h"

namespace welkin::placement {

geometry::PlacedSector placeSector(const geometry::Tracer& tracer, geometry::SectorId id,
                                   const PlacementSettings& settings, PlacementReport& report,
                                   const base::Progress& progress) {
  checkSettings(settings);
  report = {};
  geometry::PlacedSector result;
  result.id = id;
  const double top_y = topOver(tracer.surfaces(), id).value_or(0.0);
  const Candidates candidates = candidatesOf(tracer, id, settings, top_y, report, progress);
  result.probe = selectProbes(tracer, id, candidates, settings, report, progress);
  fillGrid(tracer, settings, candidates.ground_y, top_y, result, report, progress);
  setRooms(settings, result);
  return result;
}

std::vector<geometry::Probe> placeProbes(const geometry::Tracer& tracer, geometry::SectorId id,
                                         const PlacementSettings& settings, const base::Progress& progress) {
  checkSettings(settings);
  PlacementReport report;
  const double top_y = topOver(tracer.surfaces(), id).value_or(0.0);
  return selectProbes(tracer, id, candidatesOf(tracer, id, settings, top_y, report, progress), settings, report,
                      progress);
}

}  // namespace welkin::placement
