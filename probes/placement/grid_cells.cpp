// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/grid_cells.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace welkin::placement {
namespace {

constexpr double kThinnest_m = 0.02;  // air thinner than this holds no point

void addPoints(GridCell& cell, const std::vector<Span>& air, double x, double z, double low_y, double high_y) {
  for (const Span& span : air) {
    const double low = std::max(span.low_y, low_y);
    const double high = std::min(span.high_y, high_y);
    const Number3 p{x, 0.5 * (low + high), z};
    if (!span.hasFloor() || high - low < kThinnest_m) continue;
    cell.above_ground = true;
    if (!(cell.middle_free && p == cell.middle)) cell.point.push_back(p);
  }
}

std::vector<Span> airAt(const geometry::Tracer& tracer, double x, double z, double top_y) {
  std::vector<Span> result = spansAt(tracer, x, z, top_y);
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
      addPoints(cell, middle, x, z, low_y + j * cell_height_m, low_y + (j + 1) * cell_height_m);
    }
    for (const double dz : {-0.25 * geometry::kCell_m, 0.25 * geometry::kCell_m})
      for (const double dx : {-0.25 * geometry::kCell_m, 0.25 * geometry::kCell_m}) {
        const std::vector<Span> air = airAt(tracer, x + dx, z + dz, top_y);
        for (int j = 0; j < geometry::kCells; ++j)
          addPoints(result.cell[cellIndex(i, j, k)], air, x + dx, z + dz, low_y + j * cell_height_m,
                    low_y + (j + 1) * cell_height_m);
      }
  });
  return result;
}

}  // namespace welkin::placement
