// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/cell_cuts.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>

#include "probes/placement/air_memo.h"
#include "probes/placement/cut_packing.h"
#include "probes/placement/cut_tree.h"
#include "probes/placement/grid_cells.h"

namespace welkin::placement {
namespace {

/// How far within a cell a point stands for its face.
constexpr double kWithin_m = 0.15;

/// Depths at which the air of another sector's cell is looked for, metres from its face.
constexpr double kDepth_m[] = {kWithin_m, 0.4, 0.8, 1.6};

/// A cell with geometry, and what was found of it.
struct CutCell {
  std::vector<std::size_t> near;  ///< probes
  std::vector<CutSample> sample;
  CutTree tree;
};

struct Step {
  int x, y, z;
};

bool sharesFace(const Step& s) {
  return std::abs(s.x) + std::abs(s.y) + std::abs(s.z) == 1;
}

class Cutter {
 public:
  Cutter(const geometry::Tracer& tracer, const geometry::PlacedSector& sector, const std::vector<ProbeLook>& look,
         bool lamps_come, const base::Progress& progress)
      : tracer_(tracer),
        sector_(sector),
        progress_(progress),
        sight_(tracer, sector.probe, look, lamps_come),
        sampler_(tracer, sight_, sector.id),
        cell_(kAllCells) {}

  SectorCuts cut() {
    const auto faces = cellFacesOf(tracer_.surfaces(), sector_.id, sector_.low_y, sector_.cell_height_m);
    tbb::parallel_for(std::size_t{0}, kAllCells, [&](std::size_t i) {
      if (faces[i].empty()) return;
      progress_.check();
      grow(i, faces[i]);
    });
    tbb::parallel_for(std::size_t{0}, kAllCells, [&](std::size_t i) {
      if (cell_[i].sample.empty()) return;
      progress_.check();
      settleMasks(i);
    });
    CutPacker packer;
    for (std::size_t i = 0; i < kAllCells; ++i) {
      if (cell_[i].sample.empty()) continue;
      const CutTree tree = simplified(cell_[i].tree);
      const bool is_whole =
          !tree[0].plane && tree[0].probe == sector_.grid[i] && (tree[0].open | tree[0].any) == format::kAllOpen;
      if (!is_whole) packer.add(i, tree);
    }
    return packer.finish();
  }

 private:
  geometry::Box boxOf(std::size_t cell) const {
    return boxOfCell(sector_.id, sector_.low_y, sector_.cell_height_m, cell);
  }

  /// Calls visit(step, cell about it or nothing outside of the sector, its box) for the cells about a cell, without
  /// rows outside of the grid.
  template <typename Visit>
  void visitAll(std::size_t cell, const Visit& visit) const {
    const geometry::Box box = boxOf(cell);
    const std::array<int, 3> at{static_cast<int>(cell) % geometry::kCells,
                                static_cast<int>(cell) / geometry::kCells % geometry::kCells,
                                static_cast<int>(cell) / (geometry::kCells * geometry::kCells)};
    for (int i = 0; i < 27; ++i) {
      const Step step{i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
      const int x = at[0] + step.x, y = at[1] + step.y, z = at[2] + step.z;
      if (i == 13 || y < 0 || y >= geometry::kCells) continue;
      const Number3 moved(step.x * geometry::kCell_m, step.y * sector_.cell_height_m, step.z * geometry::kCell_m);
      const bool is_here = x >= 0 && x < geometry::kCells && z >= 0 && z < geometry::kCells;
      visit(step, is_here ? std::optional(cellIndex(x, y, z)) : std::nullopt,
            geometry::Box{box.low + moved, box.high + moved});
    }
  }

  /// The same for the seven of them that the filter uses at a place of the cell.
  template <typename Visit>
  void visitBeside(std::size_t cell, const Number3& p, const Visit& visit) const {
    const geometry::Box box = boxOf(cell);
    const auto isTowards = [&](int axis, int step) {
      const bool is_low = p[axis] < 0.5 * (box.low[axis] + box.high[axis]);
      return step == 0 || step == (is_low ? -1 : 1);
    };
    visitAll(cell, [&](const Step& step, const auto& other, const geometry::Box& other_box) {
      if (isTowards(0, step.x) && isTowards(1, step.y) && isTowards(2, step.z)) visit(step, other, other_box);
    });
  }

  static Number3 nearestIn(const geometry::Box& box, const Number3& p, double within_m) {
    Number3 result;
    for (int axis = 0; axis < 3; ++axis) {
      const bool is_outside = p[axis] < box.low[axis] || p[axis] > box.high[axis];
      const double within = is_outside ? within_m : 0.0;
      result[axis] = std::clamp(p[axis], box.low[axis] + within, box.high[axis] - within);
    }
    return result;
  }

  /// Whether geometry parts a sample from the nearest air of another cell. Where that air sees a probe, it is not
  /// parted if that probe may stand for the sample as well.
  bool isParted(AirMemo& air, CutSample& sample, const geometry::Box& other, bool is_here) const {
    const Number3 to = nearestIn(other, sample.position, kWithin_m);
    if (sampler_.sees(sample.position, to)) return false;
    if (const auto probe = air.nearestSeen(to)) return !sampler_.fits(sample, *probe);
    if (is_here) return false;  // settleMasks decides
    return std::any_of(std::begin(kDepth_m), std::end(kDepth_m),
                       [&](double depth_m) { return !air.isInside(nearestIn(other, sample.position, depth_m)); });
  }

  void grow(std::size_t i, const std::vector<CellFace>& faces) {
    CutCell& cell = cell_[i];
    cell.near = sampler_.probesNear((boxOf(i).low + boxOf(i).high) * 0.5);
    cell.sample = sampler_.samplesOf(i, boxOf(i), faces, cell.near);
    AirMemo air(tracer_, sampler_, cell.near);
    for (CutSample& sample : cell.sample)
      visitBeside(i, sample.position, [&](const Step& s, const auto& other, const geometry::Box& box) {
        const std::uint32_t bit = format::openBit(s.x, s.y, s.z);
        sample.beside |= bit;
        if (!sharesFace(s)) return;
        if (isParted(air, sample, box, other.has_value())) sample.shut |= bit;
      });
    if (!cell.sample.empty())
      cell.tree = growTree(sampler_, sight_, sector_.id, sector_.grid[i], candidatePlanes(faces), cell.sample);
  }

  /// The probe that a lookup from a place of a cut cell takes of another cell.
  std::uint8_t probeOf(std::size_t cell, const Number3& from, std::size_t other, const Number3& nearest) const {
    if (cell_[other].sample.empty()) return sector_.grid[other];
    const format::FromCorner to =
        besideWalls(cell_[cell].tree, fromCornerOf(sector_.id, from), fromCornerOf(sector_.id, nearest));
    return leafAt(cell_[other].tree, to).probe;
  }

  /// Whether a lookup from a sample of a leaf must not take a cell beside it. `sealed` if no way at all joins them.
  struct Answer {
    bool counts = false;  ///< false: nothing to say, such as for a cell without a probe
    bool parted = false, sealed = false;
  };
  Answer answerOf(std::size_t cell, AirMemo& air, CutSample& sample, const CutNode& leaf, const Step& step,
                  const std::optional<std::size_t>& other, const geometry::Box& box) const {
    if (!other) {
      const std::uint32_t bit = format::openBit(step.x, step.y, step.z);
      const bool is_known = sharesFace(step) && (sample.beside & bit) != 0;  // grow has asked
      return {true, is_known ? (sample.shut & bit) != 0 : isParted(air, sample, box, false), false};
    }
    const std::uint8_t probe = probeOf(cell, sample.position, *other, nearestIn(box, sample.position, 0.0));
    if (probe == geometry::kNoProbe) return {};
    if (probe == leaf.probe || sampler_.fits(sample, probe)) return {true, false, false};
    const Number3 to = nearestIn(box, sample.position, kWithin_m);
    const bool is_seen = sampler_.sees(sample.position, to) && sampler_.sees(to, sight_.position(probe));
    return {true, !is_seen, !is_seen && !sight_.joined(sample.nearest, probe)};
  }

  /// The masks of a cell's leaves: by the probe that a lookup would take beside it, or in another sector by geometry.
  void settleMasks(std::size_t i) {
    CutCell& cell = cell_[i];
    AirMemo air(tracer_, sampler_, cell.near);
    for (CutNode& leaf : cell.tree) {
      if (leaf.plane) continue;
      std::array<std::size_t, 27> all{}, parted{}, sealed{};
      const auto count = [&](CutSample& sample, const Step& step, const auto& other, const geometry::Box& box) {
        const auto bit = static_cast<std::size_t>(std::countr_zero(format::openBit(step.x, step.y, step.z)));
        const Answer answer = answerOf(i, air, sample, leaf, step, other, box);
        all[bit] += answer.counts ? 1 : 0;
        parted[bit] += answer.parted ? 1 : 0;
        sealed[bit] += answer.sealed ? 1 : 0;
      };
      std::uint32_t beside = 0;
      for (const std::uint32_t s : leaf.sample) {
        beside |= cell.sample[s].beside;
        visitBeside(i, cell.sample[s].position, [&](const Step& step, const auto& other, const geometry::Box& box) {
          count(cell.sample[s], step, other, box);
        });
      }
      // Where no sample is on a neighbour's side, a few of all speak for the points that may be.
      constexpr std::size_t kFew = 8;
      visitAll(i, [&](const Step& step, const auto& other, const geometry::Box& box) {
        if ((beside & format::openBit(step.x, step.y, step.z)) != 0) return;
        const std::size_t few = std::min(kFew, leaf.sample.size());
        for (std::size_t k = 0; k < few; ++k)
          count(cell.sample[leaf.sample[k * leaf.sample.size() / few]], step, other, box);
      });
      for (std::size_t bit = 0; bit < 27; ++bit) {
        const std::uint32_t mark = std::uint32_t{1} << bit;
        const bool shut = sealed[bit] > 0 || isMany(parted[bit], all[bit]);
        leaf.open = shut ? leaf.open & ~mark : leaf.open | mark;
        if (!shut && ((beside & mark) == 0 || all[bit] == 0) && mark != format::kOwnOpen) leaf.any |= mark;
      }
    }
  }

  const geometry::Tracer& tracer_;
  const geometry::PlacedSector& sector_;
  const base::Progress& progress_;
  ProbeSight sight_;
  CutSampler sampler_;
  std::vector<CutCell> cell_;
};

}  // namespace

SectorCuts cutCells(const geometry::Tracer& tracer, const geometry::PlacedSector& sector,
                    const std::vector<ProbeLook>& look, bool lamps_come, const base::Progress& progress) {
  if (sector.probe.empty()) return {};
  return Cutter(tracer, sector, look, lamps_come, progress).cut();
}

}  // namespace welkin::placement
