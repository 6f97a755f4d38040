// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/lattice.h"

#include <algorithm>

namespace welkin::placement {

LineRange linesWithin(int sector, double low, double high, double spacing_m, double aside_m) {
  const double corner = geometry::kSector_m * sector;
  const double from = std::max(low - corner, 0.0);
  const double to = std::min(high - corner, std::nextafter(geometry::kSector_m, 0.0));
  // The division rounds, so the ends are found by the lines themselves.
  const auto at = [&](int n) { return lineAt(0, n, spacing_m, aside_m); };
  const auto before = [&](double v) { return static_cast<int>(std::floor((v - aside_m) / spacing_m - 0.5)); };
  LineRange range{before(from) - 1, before(to) + 1};
  while (at(range.first) < from) ++range.first;
  while (at(range.last) > to) --range.last;
  return range;
}

std::vector<LatticeLine> latticeOf(const geometry::SectorId& id, double spacing_m) {
  const geometry::Number3 corner = geometry::cornerOf(id);
  const auto lines = [&](int sector, double low, double aside_m) {
    return linesWithin(sector, low, low + geometry::kSector_m, spacing_m, aside_m);
  };
  const LineRange along_x = lines(id.x, corner.x, kLattice_x_m);
  const LineRange along_z = lines(id.z, corner.z, kLattice_z_m);
  std::vector<LatticeLine> result;
  for (int k = along_z.first; k <= along_z.last; ++k)
    for (int i = along_x.first; i <= along_x.last; ++i)
      result.push_back({i, k, lineAt(id.x, i, spacing_m, kLattice_x_m), lineAt(id.z, k, spacing_m, kLattice_z_m)});
  return result;
}

}  // namespace welkin::placement
