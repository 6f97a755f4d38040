// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/grid_cells.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <functional>

namespace welkin::placement {
namespace {

constexpr double kThinnest_m = 0.02;     // air thinner than this holds no point
constexpr double kLeastAsked_m = 0.1;    // air thinner than this is not asked whether it is inside of bodies
constexpr std::size_t kMostPoints = 16;  // of a cell: those in the highest air

void addPoints(GridCell& cell, std::vector<double>& height_m, const std::vector<Span>& air, double x, double z,
               double low_y, double high_y) {
  for (const Span& span : air) {
    const double low = std::max(span.low_y, low_y);
    const double high = std::min(span.high_y, high_y);
    const Number3 p{x, 0.5 * (low + high), z};
    if (!span.hasFloor() || high - low < kThinnest_m) continue;
    cell.above_ground = true;
    if (cell.middle_free && p == cell.middle) continue;
    cell.point.push_back(p);
    height_m.push_back(high - low);
  }
}

/// Drops the points in the lowest air; `height_m` is of the last points.
void keepHighest(GridCell& cell, const std::vector<double>& height_m) {
  if (cell.point.size() <= kMostPoints) return;
  std::vector<double> sorted = height_m;
  const std::size_t middle = cell.point.size() - height_m.size();
  std::sort(sorted.begin(), sorted.end(), std::greater<>());
  const double least = sorted[kMostPoints - middle - 1];
  std::size_t kept = middle;
  for (std::size_t i = 0; i < height_m.size() && kept < kMostPoints; ++i)
    if (height_m[i] >= least) cell.point[kept++] = cell.point[middle + i];
  cell.point.resize(kept);
}

std::vector<Span> airAt(const geometry::Tracer& tracer, double x, double z, double top_y) {
  std::vector<Span> result = spansAt(tracer, x, z, top_y, kLeastAsked_m);
  std::erase_if(result, [](const Span& span) { return span.inside; });
  return result;
}

}  // namespace

GridCells gridCellsOf(const geometry::Tracer& tracer, const geometry::SectorId& id, double low_y, double cell_height_m,
                      double top_y) {
  GridCells result;
  result.cell.resize(kAllCells);
  tbb::parallel_for(0, geometry::kCells * geometry::kCells, [&](int column) {
    const int i = column % geometry::kCells;
    const int k = column / geometry::kCells;
    const double x = geometry::kSector_m * id.x + (i + 0.5) * geometry::kCell_m + kAside_x_m;
    const double z = geometry::kSector_m * id.z + (k + 0.5) * geometry::kCell_m + kAside_z_m;
    std::array<std::vector<double>, geometry::kCells> height_m;
    const std::vector<Span> middle = airAt(tracer, x, z, top_y);
    for (const Span& span : middle)
      if (span.hasFloor()) result.top[static_cast<std::size_t>(column)] = span;
    for (int j = 0; j < geometry::kCells; ++j) {
      GridCell& cell = result.cell[cellIndex(i, j, k)];
      cell.middle = {x, low_y + (j + 0.5) * cell_height_m, z};
      for (const Span& span : middle)
        if (span.low_y < cell.middle.y && cell.middle.y < span.high_y) {
          cell.middle_free = true;
          cell.middle_above_ground = span.hasFloor();
        }
      if (cell.middle_free) cell.point.push_back(cell.middle);
      addPoints(cell, height_m[static_cast<std::size_t>(j)], middle, x, z, low_y + j * cell_height_m,
                low_y + (j + 1) * cell_height_m);
    }
    for (const double dz : {-0.25 * geometry::kCell_m, 0.25 * geometry::kCell_m})
      for (const double dx : {-0.25 * geometry::kCell_m, 0.25 * geometry::kCell_m}) {
        const std::vector<Span> air = airAt(tracer, x + dx, z + dz, top_y);
        for (int j = 0; j < geometry::kCells; ++j)
          addPoints(result.cell[cellIndex(i, j, k)], height_m[static_cast<std::size_t>(j)], air, x + dx, z + dz,
                    low_y + j * cell_height_m, low_y + (j + 1) * cell_height_m);
      }
    for (int j = 0; j < geometry::kCells; ++j)
      keepHighest(result.cell[cellIndex(i, j, k)], height_m[static_cast<std::size_t>(j)]);
  });
  return result;
}

}  // namespace welkin::placement
