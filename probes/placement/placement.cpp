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
                                   const Checkpoint& checkpoint) {
  checkSettings(settings);
  report = {};
  geometry::PlacedSector result;
  result.id = id;
  const double top_y = topOver(tracer.surfaces(), id).value_or(0.0);
  const Candidates candidates = candidatesOf(tracer, id, settings, top_y, report, checkpoint);
  result.probe = selectProbes(tracer, id, candidates, settings, report, checkpoint);
  fillGrid(tracer, settings, candidates.ground_y, top_y, result, report, checkpoint);
  setRooms(settings, result);
  return result;
}

std::vector<geometry::Probe> placeProbes(const geometry::Tracer& tracer, geometry::SectorId id,
                                         const PlacementSettings& settings, const Checkpoint& checkpoint) {
  checkSettings(settings);
  PlacementReport report;
  const double top_y = topOver(tracer.surfaces(), id).value_or(0.0);
  return selectProbes(tracer, id, candidatesOf(tracer, id, settings, top_y, report, checkpoint), settings, report,
                      checkpoint);
}

}  // namespace welkin::placement
