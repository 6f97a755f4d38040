// SPDX-License-Identifier: Apache-2.0
// The parts of static triangles that lie in or beside each cell of a sector, with their planes as a file holds them.
#pragma once

#include <vector>

#include "format/cell_cuts.h"
#include "probes/geometry/sector.h"
#include "probes/geometry/surfaces.h"

namespace welkin::placement {

using f64::Number3;

/// How far beside a cell its faces are collected.
inline constexpr double kBesideCell_m = 0.2;

/// A convex part of a triangle.
struct CellFace {
  std::vector<Number3> corner;  ///< of the part within the cell; empty if it is only beside the cell
  double area_m2 = 0.0;         ///< of that part
  Number3 normal;               ///< unit
  format::CutPlane plane;       ///< from the sector's corner; its normal has y >= 0
};

/// The faces of each cell: x + kCells (y + kCells z), in the order of the surfaces' triangles.
std::vector<std::vector<CellFace>> cellFacesOf(const geometry::Surfaces& surfaces, const geometry::SectorId& id,
                                               double low_y, double cell_height_m);

/// The plane through a point with a unit normal, or its opposite, as a file holds it. The point counts from the
/// sector's corner.
format::CutPlane cutPlaneOf(const Number3& normal, const Number3& through);

/// The box of a cell in the world.
geometry::Box boxOfCell(const geometry::SectorId& id, double low_y, double cell_height_m, std::size_t cell);

}  // namespace welkin::placement
