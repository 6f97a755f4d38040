// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/lattice.h"

namespace welkin::placement {

std::vector<LatticeLine> latticeOf(const geometry::SectorId& id, double spacing_m) {
  // One line more at either end, because sectorAt defines the sector, however the division rounds.
  const auto ends = [&](int sector, double aside_m) {
    return std::pair{lineFrom(geometry::kSector_m * sector, spacing_m, aside_m) - 1,
                     lineFrom(geometry::kSector_m * (sector + 1.0), spacing_m, aside_m) + 1};
  };
  const auto [first_i, last_i] = ends(id.x, kLattice_x_m);
  const auto [first_k, last_k] = ends(id.z, kLattice_z_m);
  std::vector<LatticeLine> result;
  for (int k = first_k; k <= last_k; ++k)
    for (int i = first_i; i <= last_i; ++i) {
      const LatticeLine line{i, k, lineAt(i, spacing_m, kLattice_x_m), lineAt(k, spacing_m, kLattice_z_m)};
      if (geometry::sectorAt({line.x, 0, line.z}) == id) result.push_back(line);
    }
  return result;
}

}  // namespace welkin::placement
