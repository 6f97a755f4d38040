// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/candidates.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "probes/placement/lattice.h"
#include "probes/placement/validity.h"
#include "probes/placement/vegetation_boxes.h"

namespace welkin::probes {
namespace {

constexpr double kFoot_m = 0.1;
constexpr double kWalkable_normal_y = 0.5;  // 60 degrees

bool isRemoved(const PlacementSettings& settings, const Number3& p) {
  return std::any_of(settings.remove.begin(), settings.remove.end(), [&](const Box& box) { return contains(box, p); });
}

/// A place as it was wanted, and what became of it.
struct Wanted {
  Number3 position;
  bool by_hand = false;
  bool removed = false;
  Place place = Place::free;
  std::optional<Number3> settled;
};

/// Above ground a probe stays in sight of the `foot` of its place.
Wanted settle(const Tracer& tracer, const SectorId& id, const PlacementSettings& settings, const Number3& position,
              bool by_hand, const std::optional<Number3>& foot = {}) {
  Wanted result{position, by_hand, !by_hand && isRemoved(settings, position), Place::free, std::nullopt};
  if (result.removed) return result;
  result.place = placeAt(tracer, position, settings.clearance_m);
  const bool stays = result.place == Place::free || (by_hand && result.place == Place::too_close);
  if (stays) {
    result.settled = position;
    return result;
  }
  const std::size_t room = roomOf(settings, position);
  result.settled = freePlaceNear(tracer, position, settings.clearance_m, [&](const Number3& to) {
    return sectorAt(to) == id && roomOf(settings, to) == room && (by_hand || !isRemoved(settings, to)) &&
           (!foot || sees(tracer, *foot, to));
  });
  return result;
}

void take(const Wanted& wanted, Candidates& result, PlacementReport& report) {
  if (wanted.removed) {
    ++report.removed;
  } else if (wanted.settled) {
    if (!(*wanted.settled == wanted.position))
      report.moved.push_back({wanted.position, *wanted.settled, wanted.by_hand});
    result.candidate.push_back({*wanted.settled, wanted.by_hand});
  } else {
    const auto reason = wanted.place == Place::inside ? DroppedProbe::Reason::inside : DroppedProbe::Reason::too_close;
    report.dropped.push_back({wanted.position, reason, wanted.by_hand});
  }
}

/// What a line of the lattice meets.
struct Column {
  int preference = 0;
  std::size_t buried = 0;
  std::size_t low = 0;
  std::vector<double> ground_y;
  std::vector<Number3> walkable;
  std::vector<Wanted> wanted;
};

Column columnAt(const Tracer& tracer, const SectorId& id, const PlacementSettings& settings, const LatticeLine& line,
                double top_y) {
  Column result;
  const bool odd_i = line.i % 2 != 0;
  const bool odd_k = line.k % 2 != 0;
  result.preference = odd_i != odd_k ? 2 : odd_i ? 1 : 0;
  for (const Span& span : spansAt(tracer, line.x, line.z, top_y)) {
    if (!span.hasFloor()) continue;
    const double height = span.high_y - span.low_y;
    if (span.inside) {
      ++result.buried;
    } else if (height < settings.headroom_m) {
      ++result.low;
    } else {
      const Number3 above{line.x, span.low_y + std::min(settings.height_m, 0.5 * height), line.z};
      result.ground_y.push_back(span.low_y);
      const Number3 foot{line.x, span.low_y + kFoot_m, line.z};
      result.wanted.push_back(settle(tracer, id, settings, above, false, foot));
      const Wanted& wanted = result.wanted.back();
      const bool behind = wanted.place == Place::inside && !wanted.settled;  // of surfaces with one side
      if (span.floor_normal_y >= kWalkable_normal_y && !wanted.removed && !behind) result.walkable.push_back(foot);
    }
  }
  return result;
}

}  // namespace

Candidates candidatesOf(const Tracer& tracer, const SectorId& id, const PlacementSettings& settings, double top_y,
                        PlacementReport& report) {
  const std::vector<LatticeLine> lines = latticeOf(id, settings.spacing_m);
  std::vector<Column> columns(lines.size());
  tbb::parallel_for(std::size_t{0}, lines.size(),
                    [&](std::size_t i) { columns[i] = columnAt(tracer, id, settings, lines[i], top_y); });
  Candidates result;
  report.columns = columns.size();
  for (const Number3& p : settings.add)
    if (sectorAt(p) == id) take(settle(tracer, id, settings, p, true), result, report);
  for (const Column& column : columns) {
    report.buried += column.buried;
    report.low += column.low;
    report.ground += column.ground_y.size();
    result.ground_y.insert(result.ground_y.end(), column.ground_y.begin(), column.ground_y.end());
    result.walkable.insert(result.walkable.end(), column.walkable.begin(), column.walkable.end());
  }
  report.walkable = result.walkable.size();
  for (int preference = 0; preference < 3; ++preference)
    for (const Column& column : columns)
      if (column.preference == preference)
        for (const Wanted& wanted : column.wanted) take(wanted, result, report);
  for (const Number3& p : aboveVegetation(vegetationBoxes(tracer.surfaces()), settings, id))
    take(settle(tracer, id, settings, p, false), result, report);
  return result;
}

}  // namespace welkin::probes
