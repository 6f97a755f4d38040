// SPDX-License-Identifier: Apache-2.0
// The cells of a sector's grid, and the points in them that are in the air.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "probes/placement/column.h"

namespace welkin::placement {

using f64::Number3;

inline constexpr std::size_t kAllCells = std::size_t{geometry::kCells} * geometry::kCells * geometry::kCells;

/// Index of a cell: x + kCells (y + kCells z).
inline std::size_t cellIndex(int x, int y, int z) {
  return static_cast<std::size_t>(x + geometry::kCells * (y + geometry::kCells * z));
}

struct GridCell {
  Number3 middle;  ///< on a vertical line beside the true middle, see kAside_x_m
  bool middle_free = false;
  bool middle_above_ground = false;  ///< if false, it may be outside the level, behind all surfaces
  bool above_ground = false;         ///< has air with a floor, in the cell or below it
  std::vector<Number3> point;        ///< at most 16 points in the air; the middle
                                     ///< comes first if it is one
};

struct GridCells {
  std::vector<GridCell> cell;  ///< kAllCells
  std::array<std::optional<Span>, std::size_t{geometry::kCells} * geometry::kCells>
      top;  ///< highest span with a floor: x + kCells z
};

/// Computes the points of all cells. A cell has its middle. Above ground it also has the middle of every span of air
/// within it, along its middle line and four others halfway to its corners.
GridCells gridCellsOf(const geometry::Tracer& tracer, const geometry::SectorId& id, double low_y, double cell_height_m,
                      double top_y);

}  // namespace welkin::placement
