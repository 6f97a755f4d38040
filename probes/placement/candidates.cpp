// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/candidates.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <limits>

#include "probes/placement/ground_part.h"
#include "probes/placement/lattice.h"
#include "probes/placement/validity.h"
#include "probes/placement/vegetation_boxes.h"

namespace welkin::placement {
namespace {

constexpr double kFoot_m = 0.1;

bool isRemoved(const PlacementSettings& settings, const Number3& p) {
  return std::any_of(settings.remove.begin(), settings.remove.end(),
                     [&](const geometry::Box& box) { return geometry::contains(box, p); });
}

/// A wanted place and the result of settling it.
struct Wanted {
  Number3 position;
  bool by_hand = false;
  bool removed = false;
  Place place = Place::free;
  std::optional<Number3> foot;  ///< of a probe above ground, which stays in sight of it
  std::optional<Number3> settled;
  bool mustMove() const { return !removed && !settled; }
};

/// Asks whether a probe may stand at the place itself.
Wanted ask(const geometry::Tracer& tracer, const PlacementSettings& settings, const Number3& position, bool by_hand,
           const std::optional<Number3>& foot = {}) {
  Wanted result{position, by_hand, !by_hand && isRemoved(settings, position), Place::free, foot, std::nullopt};
  if (result.removed) return result;
  result.place = placeAt(tracer, position, settings.clearance_m);
  if (result.place == Place::free || (by_hand && result.place == Place::too_close)) result.settled = position;
  return result;
}

/// Searches for a free place near one where none may stand. Returns the rays that it took.
std::size_t search(const geometry::Tracer& tracer, const geometry::SectorId& id, const PlacementSettings& settings,
                   Wanted& wanted) {
  const std::size_t room = roomOf(settings, wanted.position);
  const Search result = freePlaceNear(tracer, wanted.position, settings.clearance_m, [&](const Number3& to) {
    return geometry::sectorAt(to) == id && roomOf(settings, to) == room &&
           (wanted.by_hand || !isRemoved(settings, to)) && (!wanted.foot || sees(tracer, *wanted.foot, to));
  });
  wanted.settled = result.found;
  return result.rays;
}

/// Finds a free place, as long as there are rays left. Probes by hand are always searched for.
Wanted settle(const geometry::Tracer& tracer, const geometry::SectorId& id, const PlacementSettings& settings,
              const Number3& position, bool by_hand, std::size_t& search_rays,
              const std::optional<Number3>& foot = {}) {
  Wanted wanted = ask(tracer, settings, position, by_hand, foot);
  if (wanted.mustMove() && (by_hand || search_rays > 0))
    search_rays -= std::min(search_rays, search(tracer, id, settings, wanted));
  return wanted;
}

std::optional<Candidate> take(const Wanted& wanted, PlacementReport& report) {
  if (wanted.removed) {
    ++report.removed;
    return std::nullopt;
  }
  if (!wanted.settled) {
    const auto reason = wanted.place == Place::inside ? DroppedProbe::Reason::inside : DroppedProbe::Reason::too_close;
    report.dropped.push_back({wanted.position, reason, wanted.by_hand});
    return std::nullopt;
  }
  if (!(*wanted.settled == wanted.position)) report.moved.push_back({wanted.position, *wanted.settled, wanted.by_hand});
  return Candidate{*wanted.settled, wanted.by_hand};
}

/// Ground at one height of a line.
struct Ground {
  double y = 0.0;
  bool walkable = false;
  WalkablePoint point;
};

/// The ground that a line of the lattice meets.
struct LatticeColumn {
  int preference = 0;
  std::size_t spans = 0;  ///< of air
  std::size_t buried = 0;
  std::size_t low = 0;
  std::size_t under_water = 0;
  std::vector<Ground> ground;
  std::vector<Wanted> wanted;  // one per ground
};

/// Whether water is the first surface above a point, leaves ignored.
bool isUnderWater(const geometry::Tracer& tracer, Number3 point) {
  const geometry::Surfaces& s = tracer.surfaces();
  while (const auto hit = tracer.closest(point, {0, 1, 0}, std::numeric_limits<double>::infinity())) {
    const geometry::Role role = s.object[s.triangle[hit->triangle].object].role;
    if (role != geometry::Role::vegetation) return role == geometry::Role::water;
    point.y += hit->distance + kFoot_m;
  }
  return false;
}

LatticeColumn groundAt(const geometry::Tracer& tracer, const PlacementSettings& settings, const LatticeLine& line,
                       double top_y) {
  LatticeColumn result;
  const std::vector<Span> air = spansAt(tracer, line.x, line.z, top_y, settings.headroom_m);
  result.spans = air.size();
  for (const Span& span : air) {
    if (!span.hasFloor()) continue;
    const double height = span.high_y - span.low_y;
    if (span.inside) {
      ++result.buried;
    } else if (height < settings.headroom_m) {
      ++result.low;
    } else if (isUnderWater(tracer, {line.x, span.low_y + kFoot_m, line.z})) {
      ++result.under_water;
    } else {
      const Number3 above{line.x, span.low_y + std::min(settings.height_m, 0.5 * height), line.z};
      const bool walkable = span.floor_normal_y >= kWalkable_normal_y && !isRemoved(settings, above);
      result.ground.push_back({span.low_y, walkable, {{line.x, span.low_y + kFoot_m, line.z}, above, true}});
    }
  }
  return result;
}

/// Ground with the place above it.
LatticeColumn columnAt(const geometry::Tracer& tracer, const PlacementSettings& settings, const LatticeLine& line,
                       double top_y) {
  LatticeColumn result = groundAt(tracer, settings, line, top_y);
  const bool odd_i = line.i % 2 != 0;
  const bool odd_k = line.k % 2 != 0;
  result.preference = odd_i != odd_k ? 2 : odd_i ? 1 : 0;
  for (const Ground& ground : result.ground)
    result.wanted.push_back(ask(tracer, settings, ground.point.above, false, ground.point.foot));
  return result;
}

/// The rays that the searches of a sector may take, by the spans on its lines.
std::size_t searchRaysFor(const std::vector<LatticeColumn>& columns) {
  constexpr std::size_t kOrdinary = 32;
  std::size_t spans = 0;
  for (const LatticeColumn& column : columns) spans += column.spans;
  if (spans <= kOrdinary * columns.size()) return kMostSearchRays;
  return kMostSearchRays * kOrdinary * columns.size() / spans;
}

/// Searches for free places for all columns, side by side in blocks, until there are no rays left.
void searchAll(const geometry::Tracer& tracer, const geometry::SectorId& id, const PlacementSettings& settings,
               std::vector<LatticeColumn>& columns, std::size_t& search_rays, const base::Progress& progress) {
  constexpr std::size_t kBlock = 16;
  std::vector<Wanted*> all;
  for (LatticeColumn& column : columns)
    for (Wanted& wanted : column.wanted)
      if (wanted.mustMove()) all.push_back(&wanted);
  for (std::size_t from = 0; from < all.size() && search_rays > 0; from += kBlock) {
    const std::size_t to = std::min(from + kBlock, all.size());
    std::array<std::size_t, kBlock> rays{};
    tbb::parallel_for(from, to, [&](std::size_t i) {
      progress.check();
      rays[i - from] = search(tracer, id, settings, *all[i]);
    });
    for (const std::size_t r : rays) search_rays -= std::min(search_rays, r);
  }
  for (LatticeColumn& column : columns)
    for (std::size_t i = 0; i < column.ground.size(); ++i)  // behind one-sided surfaces
      if (column.wanted[i].place == Place::inside && !column.wanted[i].settled) column.ground[i].walkable = false;
}

/// Lines for ground that no line of the lattice meets.
std::vector<LatticeLine> linesThroughParts(const geometry::Surfaces& surfaces, const geometry::SectorId& id) {
  std::vector<LatticeLine> lines;
  for (const GroundPart& part : walkableParts(surfaces, id)) lines.push_back({0, 0, part.x, part.z});
  return lines;
}

template <typename Make>
std::vector<LatticeColumn> columnsOf(const std::vector<LatticeLine>& lines, const base::Progress& progress, Make make) {
  std::vector<LatticeColumn> result(lines.size());
  tbb::parallel_for(std::size_t{0}, lines.size(), [&](std::size_t i) {
    progress.check();
    result[i] = make(lines[i]);
  });
  return result;
}

}  // namespace

Candidates candidatesOf(const geometry::Tracer& tracer, const geometry::SectorId& id, const PlacementSettings& settings,
                        double top_y, PlacementReport& report, const base::Progress& progress) {
  Candidates result;
  const auto add = [&](const Wanted& wanted) {
    progress.check();
    if (const auto candidate = take(wanted, report)) result.candidate.push_back(*candidate);
  };
  std::size_t& rays = result.search_rays;
  for (const Number3& p : settings.add)
    if (geometry::sectorAt(p) == id) add(settle(tracer, id, settings, p, true, rays));
  const auto candidatesOn = [&](const std::vector<LatticeLine>& lines) {
    std::vector<LatticeColumn> found =
        columnsOf(lines, progress, [&](const LatticeLine& line) { return columnAt(tracer, settings, line, top_y); });
    rays = searchRaysFor(found);
    searchAll(tracer, id, settings, found, rays, progress);
    return found;
  };
  const auto hasGround = [](const LatticeColumn& column) { return !column.ground.empty(); };
  std::vector<LatticeColumn> columns = candidatesOn(latticeOf(id, settings.spacing_m));
  const std::vector<LatticeColumn> between =
      columnsOf(latticeOf(id, 0.5 * settings.spacing_m), progress,
                [&](const LatticeLine& line) { return groundAt(tracer, settings, line, top_y); });
  if (std::none_of(columns.begin(), columns.end(), hasGround) &&
      std::none_of(between.begin(), between.end(), hasGround))
    for (LatticeColumn& column : candidatesOn(linesThroughParts(tracer.surfaces(), id)))
      columns.push_back(std::move(column));
  report.columns = columns.size();
  for (const LatticeColumn& column : columns) {
    report.buried += column.buried;
    report.low += column.low;
    report.under_water += column.under_water;
    report.ground += column.ground.size();
    for (const Ground& ground : column.ground) {
      result.ground_y.push_back(ground.y);
      if (ground.walkable) result.walkable.push_back(ground.point);
    }
  }
  for (int preference = 0; preference < 3; ++preference)
    for (const LatticeColumn& column : columns)
      if (column.preference == preference)
        for (const Wanted& wanted : column.wanted) add(wanted);
  for (const Number3& p : aboveVegetation(vegetationBoxes(tracer.surfaces()), settings, id))
    add(settle(tracer, id, settings, p, false, rays));
  for (const LatticeColumn& column : between)
    for (const Ground& ground : column.ground) {
      result.ground_y.push_back(ground.y);
      if (ground.walkable) result.walkable.push_back({ground.point.foot, ground.point.above, false});
    }
  return result;
}

std::optional<Candidate> candidateFor(const geometry::Tracer& tracer, const geometry::SectorId& id,
                                      const PlacementSettings& settings, const WalkablePoint& point,
                                      PlacementReport& report, std::size_t& search_rays) {
  return take(settle(tracer, id, settings, point.above, false, search_rays, point.foot), report);
}

}  // namespace welkin::placement
