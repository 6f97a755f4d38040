// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/grid.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <tuple>

#include "probes/placement/grid_cells.h"
#include "probes/placement/validity.h"

namespace welkin::placement {

using f64::Number3;
namespace {

/// How a cell came to its probe: its middle sees it, another part does, a chain of cells leads to it, or the cell is
/// inside of geometry.
enum class Sight : std::uint8_t { none, middle, part, way, inside };

/// Ordered by distance, then index. Distances are in steps of 2^-20 m, so equal distances stay equal in every sector.
struct Choice {
  std::size_t probe = 0;
  double distance_m = 0.0;
  Choice(std::size_t probe_, double exact_m) : probe(probe_), distance_m(std::round(exact_m * 0x1p20) * 0x1p-20) {}
  bool operator<(const Choice& b) const { return std::tie(distance_m, probe) < std::tie(b.distance_m, b.probe); }
};

/// From above, a cell without a probe takes the probe of the nearest cell that has one: nearest in cells, then by
/// index.
void fillFromNearest(std::array<std::uint8_t, geometry::kCells * geometry::kCells>& top) {
  const auto named = top;
  for (int cell = 0; cell < geometry::kCells * geometry::kCells; ++cell) {
    int nearest = std::numeric_limits<int>::max();
    for (int other = 0; other < geometry::kCells * geometry::kCells; ++other) {
      const int dx = other % geometry::kCells - cell % geometry::kCells;
      const int dz = other / geometry::kCells - cell / geometry::kCells;
      const std::uint8_t probe = named[static_cast<std::size_t>(other)];
      if (probe == geometry::kNoProbe || dx * dx + dz * dz >= nearest) continue;
      top[static_cast<std::size_t>(cell)] = probe;
      nearest = dx * dx + dz * dz;
    }
  }
}

class Grid {
 public:
  Grid(const geometry::Tracer& tracer, const PlacementSettings& settings, geometry::PlacedSector& sector, double top_y,
       const base::Progress& progress)
      : tracer_(tracer),
        settings_(settings),
        sector_(sector),
        progress_(progress),
        cells_(gridCellsOf(tracer, sector.id, sector.low_y, sector.cell_height_m, top_y)),
        found_(kAllCells, Sight::none),
        anchor_(kAllCells) {
    for (const geometry::Probe& p : sector.probe) room_.push_back(roomOf(settings, p.position));
    sector_.grid.fill(geometry::kNoProbe);
  }

  void bySight() {
    tbb::parallel_for(std::size_t{0}, kAllCells, [&](std::size_t i) {
      progress_.check();
      GridCell& cell = cells_.cell[i];
      if (cell.middle_free)
        if (const auto choice = nearestSeen(cell.middle)) return name(i, choice->probe, Sight::middle, cell.middle);
      const bool doubtful = cell.middle_free && !cell.middle_above_ground;
      if (doubtful && insideGeometry(tracer_, cell.middle)) cell.point.erase(cell.point.begin());
      std::optional<Choice> best;
      Number3 from;
      for (const Number3& p : cell.point)
        if (const auto choice = nearestSeen(p, best)) {
          best = choice;
          from = p;
        }
      if (best) name(i, best->probe, Sight::part, from);
    });
  }

  void byWay() {
    std::vector<bool> fresh(kAllCells, false);
    for (std::size_t i = 0; i < kAllCells; ++i) fresh[i] = found_[i] != Sight::none;
    for (bool any = true; any;) {
      std::vector<std::optional<SeenFrom>> way(kAllCells);
      tbb::parallel_for(std::size_t{0}, kAllCells, [&](std::size_t i) {
        if (found_[i] != Sight::none) return;
        progress_.check();
        for (const std::size_t j : around(i, 1)) {
          const Number3* from = fresh[j] ? pointThatSees(i, anchor_[j]) : nullptr;
          if (from == nullptr) continue;
          const std::size_t probe = sector_.grid[j];
          const Choice choice(probe, distanceOf(cells_.cell[i].middle, sector_.probe[probe].position));
          if (!way[i] || choice < way[i]->choice) way[i] = SeenFrom{choice, *from};
        }
      });
      any = false;
      for (std::size_t i = 0; i < kAllCells; ++i) {
        fresh[i] = way[i].has_value();
        if (!way[i]) continue;
        name(i, way[i]->choice.probe, Sight::way, way[i]->from);
        any = true;
      }
    }
  }

  void byFilter() {
    std::vector<std::optional<std::size_t>> chosen(kAllCells);
    tbb::parallel_for(std::size_t{0}, kAllCells, [&](std::size_t i) {
      progress_.check();
      if (cells_.cell[i].point.empty()) chosen[i] = seenByAll(i);
    });
    for (std::size_t i = 0; i < kAllCells; ++i)
      if (chosen[i]) name(i, *chosen[i], Sight::inside, cells_.cell[i].middle);
  }

  void fillTop() {
    if (sector_.probe.empty()) return sector_.top.fill(geometry::kNoProbe);
    for (std::size_t column = 0; column < cells_.top.size(); ++column) {
      sector_.top[column] = geometry::kNoProbe;
      const auto& span = cells_.top[column];
      if (!span) continue;
      const Number3& line = cells_
                                .cell[cellIndex(static_cast<int>(column % geometry::kCells), 0,
                                                static_cast<int>(column / geometry::kCells))]
                                .middle;
      const double height = std::min(settings_.height_m, 0.5 * (span->high_y - span->low_y));
      if (const auto choice = nearestSeen({line.x, span->low_y + height, line.z}))
        sector_.top[column] = static_cast<std::uint8_t>(choice->probe);
    }
    if (std::all_of(sector_.top.begin(), sector_.top.end(),
                    [](std::uint8_t probe) { return probe == geometry::kNoProbe; }))
      nameProbesBelow();
    fillFromNearest(sector_.top);
  }

  void count(PlacementReport& report) const {
    for (std::size_t i = 0; i < kAllCells; ++i) {
      report.cells_by_middle += found_[i] == Sight::middle ? 1 : 0;
      report.cells_by_part += found_[i] == Sight::part ? 1 : 0;
      report.cells_by_way += found_[i] == Sight::way ? 1 : 0;
      report.cells_inside += found_[i] == Sight::inside ? 1 : 0;
      report.cells_without += found_[i] == Sight::none ? 1 : 0;
      report.ground_cells_without += found_[i] == Sight::none && cells_.cell[i].above_ground ? 1 : 0;
    }
  }

 private:
  /// Lets each probe serve its own cell from above; the first probe of a cell wins. Used for a sector where no surface
  /// that is seen from above sees a probe.
  void nameProbesBelow() {
    for (std::size_t i = sector_.probe.size(); i-- > 0;) {
      const auto cellOf = [](double along) {
        return std::clamp(static_cast<int>(along / geometry::kCell_m), 0, geometry::kCells - 1);
      };
      const Number3& p = sector_.probe[i].position;
      const int x = cellOf(p.x - geometry::kSector_m * sector_.id.x);
      const int z = cellOf(p.z - geometry::kSector_m * sector_.id.z);
      sector_.top[static_cast<std::size_t>(x + geometry::kCells * z)] = static_cast<std::uint8_t>(i);
    }
  }

  struct SeenFrom {
    Choice choice;
    Number3 from;
  };

  /// `anchor` is the cell's point that sees the probe or the way to it.
  void name(std::size_t cell, std::size_t probe, Sight how, const Number3& anchor) {
    sector_.grid[cell] = static_cast<std::uint8_t>(probe);
    found_[cell] = how;
    anchor_[cell] = anchor;
  }

  /// The nearest probe that a point sees, nearer than `limit` if that is given.
  std::optional<Choice> nearestSeen(const Number3& from, const std::optional<Choice>& limit = {}) const {
    std::vector<Choice> choice;
    const std::size_t room = roomOf(settings_, from);
    for (std::size_t i = 0; i < room_.size(); ++i)
      if (room_[i] == room) choice.emplace_back(i, distanceOf(from, sector_.probe[i].position));
    std::sort(choice.begin(), choice.end());
    for (const Choice& c : choice) {
      if (limit && !(c < *limit)) break;
      if (sees(tracer_, from, sector_.probe[c.probe].position)) return c;
    }
    return std::nullopt;
  }

  /// Cells that differ by one in at most `axes` of the three coordinates, within the sector.
  static std::vector<std::size_t> around(std::size_t cell, int axes) {
    const int x = static_cast<int>(cell) % geometry::kCells;
    const int y = static_cast<int>(cell) / geometry::kCells % geometry::kCells;
    const int z = static_cast<int>(cell) / (geometry::kCells * geometry::kCells);
    const auto within = [](int a) { return a >= 0 && a < geometry::kCells; };
    std::vector<std::size_t> result;
    for (int dz = -1; dz <= 1; ++dz)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const int moved = dx * dx + dy * dy + dz * dz;
          if (moved == 0 || moved > axes || !within(x + dx) || !within(y + dy) || !within(z + dz)) continue;
          result.push_back(cellIndex(x + dx, y + dy, z + dz));
        }
    return result;
  }

  const Number3* pointThatSees(std::size_t cell, const Number3& to) const {
    for (const Number3& p : cells_.cell[cell].point)
      if (roomOf(settings_, p) == roomOf(settings_, to) && sees(tracer_, p, to)) return &p;
    return nullptr;
  }

  std::optional<std::size_t> seenByAll(std::size_t cell) const {
    std::vector<std::size_t> judge;
    std::vector<Choice> choice;
    for (const std::size_t j : around(cell, 3)) {
      if (found_[j] == Sight::none) continue;
      judge.push_back(j);
      const std::size_t probe = sector_.grid[j];
      choice.emplace_back(probe, distanceOf(cells_.cell[cell].middle, sector_.probe[probe].position));
    }
    std::sort(choice.begin(), choice.end());
    for (const Choice& c : choice) {
      const bool all = std::all_of(judge.begin(), judge.end(), [&](std::size_t j) {
        return sector_.grid[j] == c.probe || (roomOf(settings_, anchor_[j]) == room_[c.probe] &&
                                              sees(tracer_, anchor_[j], sector_.probe[c.probe].position));
      });
      if (all) return c.probe;
    }
    return std::nullopt;
  }

  const geometry::Tracer& tracer_;
  const PlacementSettings& settings_;
  geometry::PlacedSector& sector_;
  const base::Progress& progress_;
  GridCells cells_;
  std::vector<Sight> found_;
  std::vector<Number3> anchor_;
  std::vector<std::size_t> room_;  // room of each probe
};

void setHeights(const std::vector<double>& ground_y, geometry::PlacedSector& sector) {
  std::vector<double> y = ground_y;
  for (const geometry::Probe& p : sector.probe) y.push_back(p.position.y);
  const auto [low, high] = std::minmax_element(y.begin(), y.end());
  sector.low_y = y.empty() ? 0.0 : geometry::kCell_m * std::floor(*low / geometry::kCell_m);
  const double height = y.empty() ? 0.0 : *high - sector.low_y;
  sector.cell_height_m = geometry::kCell_m * (std::floor(height / geometry::kSector_m) + 1.0);
}

}  // namespace

void fillGrid(const geometry::Tracer& tracer, const PlacementSettings& settings, const std::vector<double>& ground_y,
              double top_y, geometry::PlacedSector& sector, PlacementReport& report, const base::Progress& progress) {
  setHeights(ground_y, sector);
  Grid grid(tracer, settings, sector, top_y, progress);
  grid.bySight();
  grid.byWay();
  grid.byFilter();
  grid.fillTop();
  grid.count(report);
}

}  // namespace welkin::placement
