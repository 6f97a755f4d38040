// SPDX-License-Identifier: Apache-2.0
// The probes that light a point: the eight cells around it, filtered within its side of the walls. Positions are in the
// world, metres. Nothing here allocates or throws.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "format/cell_cuts.h"

namespace welkin::format {

using InWorld = std::array<double, 3>;

inline constexpr int kCellsAcross = 16;
inline constexpr double kCellWidth_m = 4.0;
inline constexpr std::uint8_t kNoCellProbe = 255;

/// A point of a surface counts as this far off it. So it is on its own side of a wall without thickness.
inline constexpr double kOffSurface_m = 0.02;

/// The part of a sector that a lookup reads.
struct GridView {
  std::span<const std::uint8_t> grid;  ///< 4096 cells
  double low_y = 0.0;                  ///< bottom, metres
  double cell_height_m = kCellWidth_m;
  CellCuts cuts;
};

/// A cell by its place in the level: columns count from the world's origin, rows from the bottom of its sector's grid.
struct CellPlace {
  int sector_x = 0, sector_z = 0;
  int x = 0, row = 0, z = 0;
  const GridView* grid = nullptr;  ///< null: no sector there, or a row outside of its grid
  std::size_t index() const {
    const int i = x - kCellsAcross * sector_x, k = z - kCellsAcross * sector_z;
    return static_cast<std::size_t>(i + kCellsAcross * (row + kCellsAcross * k));
  }
};

/// One of the eight, with its trilinear weight > 0.
struct WeightedProbe {
  int sector_x, sector_z;
  std::uint8_t probe;
  double weight;
};

struct EightProbes {
  std::array<WeightedProbe, 8> probe{};
  std::size_t count = 0;  ///< 0: no cell that may light the point has a probe
};

inline int floorToCell(double v) {
  return static_cast<int>(std::floor(v));
}

inline FromCorner fromCorner(const CellPlace& cell, const InWorld& p) {
  constexpr double kSide_m = kCellsAcross * kCellWidth_m;
  return {static_cast<float>(p[0] - kSide_m * cell.sector_x), static_cast<float>(p[1]),
          static_cast<float>(p[2] - kSide_m * cell.sector_z)};
}

/// The cell of a column at a height. `gridOf(sector_x, sector_z)` gives a const GridView*, null without a sector.
template <typename GridOf>
CellPlace cellOf(int x, double y, int z, const GridOf& gridOf) {
  CellPlace cell;
  cell.sector_x = floorToCell(static_cast<double>(x) / kCellsAcross);
  cell.sector_z = floorToCell(static_cast<double>(z) / kCellsAcross);
  cell.x = x;
  cell.z = z;
  cell.grid = gridOf(cell.sector_x, cell.sector_z);
  if (cell.grid == nullptr) return cell;
  const double row = std::floor((y - cell.grid->low_y) / cell.grid->cell_height_m);
  if (!(row >= 0.0 && row < kCellsAcross)) cell.grid = nullptr;
  if (cell.grid != nullptr) cell.row = static_cast<int>(row);
  return cell;
}

template <typename GridOf>
CellPlace cellAt(const InWorld& p, const GridOf& gridOf) {
  return cellOf(floorToCell(p[0] / kCellWidth_m), p[1], floorToCell(p[2] / kCellWidth_m), gridOf);
}

/// The place `push_m` >= 0 along a unit normal off a surface, from where its light is looked up. If a wall is nearer
/// than twice of that, the place is half of the way to it. A wall is a plane of a cut cell, or a face to a cell that is
/// not open.
template <typename GridOf>
InWorld pushedPlace(const InWorld& position, const InWorld& normal, double push_m, const GridOf& gridOf) {
  constexpr int kMostCells = 32;  // and leaves
  constexpr double kBeyond_m = 1e-4;
  constexpr double kInto_m = 1e-6;
  const auto along = [&](double way_m) {
    return InWorld{position[0] + normal[0] * way_m, position[1] + normal[1] * way_m, position[2] + normal[2] * way_m};
  };
  const FromCorner direction{static_cast<float>(normal[0]), static_cast<float>(normal[1]),
                             static_cast<float>(normal[2])};
  double way_m = std::min(kOffSurface_m, push_m);
  CellPlace cell = cellAt(along(way_m), gridOf);
  for (int step = 0; step < kMostCells && way_m < 2.0 * push_m && cell.grid != nullptr; ++step) {
    const InWorld at = along(way_m);
    const CutWay way = cutWay(cell.grid->cuts, cell.index(), kNoCellProbe, fromCorner(cell, at), direction);
    const InWorld low{kCellWidth_m * cell.x, cell.grid->low_y + cell.grid->cell_height_m * cell.row,
                      kCellWidth_m * cell.z};
    const InWorld size{kCellWidth_m, cell.grid->cell_height_m, kCellWidth_m};
    double face_m = std::numeric_limits<double>::infinity();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double end = normal[axis] > 0.0 ? low[axis] + size[axis] : low[axis];
      if (normal[axis] != 0.0) face_m = std::min(face_m, std::max(0.0, (end - at[axis]) / normal[axis]));
    }
    if (double{way.way_m} <= face_m) {
      const double wall_m = way_m + double{way.way_m};
      way_m = wall_m + kBeyond_m;
      const FromCorner beyond = fromCorner(cell, along(way_m));
      if (leafOfCell(cell.grid->cuts, cell.index(), kNoCellProbe, beyond).probe != way.leaf.probe)
        return along(std::min(push_m, 0.5 * wall_m));
      cell = cellAt(along(way_m), gridOf);
      continue;
    }
    way_m += face_m + kInto_m;
    const CellPlace next = cellAt(along(way_m), gridOf);
    const int dx = std::clamp(next.x - cell.x, -1, 1), dz = std::clamp(next.z - cell.z, -1, 1);
    const bool is_home = next.sector_x == cell.sector_x && next.sector_z == cell.sector_z;
    const int dy = next.grid != nullptr && is_home ? std::clamp(next.row - cell.row, -1, 1) : 0;
    if ((way.leaf.open & openBit(dx, dy, dz)) == 0) return along(std::min(push_m, 0.5 * way_m));
    cell = next;
  }
  return along(push_m);
}

/// What one of the eight cells about a place does for it.
enum class CellPart {
  lights,        ///< its probe counts
  no_weight,     ///< the place is in the middle of other cells
  behind_wall,   ///< a wall parts it from the place's side of its own cell
  no_sector,     ///< the level has nothing there
  without_probe  ///< no probe is near enough to see it
};

/// One of the eight cells about a place. Columns count from the world's origin, rows from the bottom of the grid of the
/// place's own sector.
struct CellAbout {
  int x = 0, row = 0, z = 0;
  CellPart part = CellPart::no_weight;
  WeightedProbe found{0, 0, kNoCellProbe, 0.0};  ///< trilinear weight; the probe if it lights
};

/// Calls `visit(const CellAbout&)` for the eight cells about a place as pushedPlace gives it. The place's own cell
/// counts with the probe of the place's leaf. Of the other seven cells, those count that the leaf calls open, each with
/// the probe of its leaf nearest to the place. Without a sector at the place nothing is visited.
template <typename GridOf, typename Visit>
void visitCellsAbout(const InWorld& p, const GridOf& gridOf, const Visit& visit) {
  const CellPlace home = cellAt(p, gridOf);
  const GridView* sector = gridOf(home.sector_x, home.sector_z);
  if (sector == nullptr) return;
  const double height_m = sector->cell_height_m;
  const InWorld at{p[0] / kCellWidth_m, (p[1] - sector->low_y) / height_m, p[2] / kCellWidth_m};
  const int row = floorToCell(at[1]);
  const CutLeaf own = home.grid == nullptr
                          ? CutLeaf{kNoCellProbe, kAllOpen}
                          : leafOfCell(sector->cuts, home.index(), sector->grid[home.index()], fromCorner(home, p));
  constexpr auto kSide_m = static_cast<float>(kCellsAcross * kCellWidth_m);
  for (int i = 0; i < 8; ++i) {
    std::array<int, 3> cell{};
    double weight = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double from = at[axis] - 0.5;
      const int step = (i >> axis) & 1;
      cell[axis] = floorToCell(from) + step;
      weight *= step == 1 ? from - std::floor(from) : 1.0 - (from - std::floor(from));
    }
    const int dx = cell[0] - home.x, dy = cell[1] - row, dz = cell[2] - home.z;
    CellAbout about{cell[0], cell[1], cell[2], CellPart::no_weight, {0, 0, kNoCellProbe, weight}};
    if (!(weight > 0.0) || (own.open & openBit(dx, dy, dz)) == 0) {
      if (weight > 0.0) about.part = CellPart::behind_wall;
      visit(about);
      continue;
    }
    const double low_y = sector->low_y + cell[1] * height_m;
    const CellPlace other = cellOf(cell[0], low_y + 0.5 * height_m, cell[2], gridOf);
    if (other.grid == nullptr) {
      about.part = CellPart::no_sector;
      visit(about);
      continue;
    }
    std::uint8_t probe = own.probe;
    if (dx != 0 || dy != 0 || dz != 0) {
      const InWorld nearest{std::clamp(p[0], kCellWidth_m * cell[0], kCellWidth_m * (cell[0] + 1)),
                            std::clamp(p[1], low_y, low_y + height_m),
                            std::clamp(p[2], kCellWidth_m * cell[2], kCellWidth_m * (cell[2] + 1))};
      FromCorner beside = fromCorner(home, nearest);
      if (home.grid != nullptr) beside = besideWalls(sector->cuts, home.index(), fromCorner(home, p), beside);
      beside[0] += kSide_m * static_cast<float>(home.sector_x - other.sector_x);
      beside[2] += kSide_m * static_cast<float>(home.sector_z - other.sector_z);
      probe = leafOfCell(other.grid->cuts, other.index(), other.grid->grid[other.index()], beside).probe;
    }
    about.part = probe == kNoCellProbe ? CellPart::without_probe : CellPart::lights;
    about.found = {other.sector_x, other.sector_z, probe, weight};
    visit(about);
  }
}

/// The probes for a place as pushedPlace gives it: those of the cells that light it. The weights of what counts are to
/// be divided by their sum.
template <typename GridOf>
EightProbes probesAbout(const InWorld& p, const GridOf& gridOf) {
  EightProbes result;
  visitCellsAbout(p, gridOf, [&](const CellAbout& cell) {
    if (cell.part == CellPart::lights) result.probe[result.count++] = cell.found;
  });
  return result;
}

}  // namespace welkin::format
