// SPDX-License-Identifier: Apache-2.0
// The lattice of vertical lines. It begins anew at every sector's corner, so a sector's probes are the same wherever in
// the world it is.
#pragma once

#include <vector>

#include "probes/placement/column.h"

namespace welkin::placement {

/// Offsets of the lattice. They keep lines away from the half metres where walls stand, by more than a probe's
/// clearance, and from sixteenths of a metre.
inline constexpr double kLattice_x_m = 0.2871;
inline constexpr double kLattice_z_m = 0.2213;

/// A line at ((i + 1/2) spacing + kLattice_x_m, (k + 1/2) spacing + kLattice_z_m) from the sector's corner.
struct LatticeLine {
  int i = 0;
  int k = 0;
  double x = 0.0;
  double z = 0.0;
};

/// The numbers first to last of a sector's lines along an axis; none if first > last.
struct LineRange {
  int first = 0;
  int last = -1;
  bool none() const { return first > last; }
};

/// Coordinate of the n-th line of sectors `sector` along an axis.
inline double lineAt(int sector, int n, double spacing_m, double aside_m) {
  return geometry::kSector_m * sector + ((n + 0.5) * spacing_m + aside_m);
}

/// The lines of sectors `sector` along an axis at low <= coordinate <= high.
LineRange linesWithin(int sector, double low, double high, double spacing_m, double aside_m);

/// The lines within a sector, by k, then i.
std::vector<LatticeLine> latticeOf(const geometry::SectorId& id, double spacing_m);

}  // namespace welkin::placement
