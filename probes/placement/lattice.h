// SPDX-License-Identifier: Apache-2.0
// The lattice of vertical lines. Its phase is fixed in the world, so neighbouring sectors match without knowing each
// other.
#pragma once

#include <vector>

#include "probes/placement/column.h"

namespace welkin::placement {

/// Offsets of the lattice. They keep lines away from the half metres where walls stand, by more than a probe's
/// clearance, and from sixteenths of a metre.
inline constexpr double kLattice_x_m = 0.2871;
inline constexpr double kLattice_z_m = 0.2213;

/// A line at ((i + 1/2) spacing + kLattice_x_m, (k + 1/2) spacing + kLattice_z_m).
struct LatticeLine {
  int i = 0;
  int k = 0;
  double x = 0.0;
  double z = 0.0;
};

/// Coordinate of the n-th line along an axis.
inline double lineAt(int n, double spacing_m, double aside_m) {
  return (n + 0.5) * spacing_m + aside_m;
}

/// The first line at or above a coordinate.
inline int lineFrom(double coordinate, double spacing_m, double aside_m) {
  return static_cast<int>(std::ceil((coordinate - aside_m) / spacing_m - 0.5));
}

/// The lines within a sector, by k, then i.
std::vector<LatticeLine> latticeOf(const geometry::SectorId& id, double spacing_m);

}  // namespace welkin::placement
