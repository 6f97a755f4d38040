// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/occlusion_tile.h"

#include <cassert>

namespace welkin::probes {
namespace {

/// The probe of a cell of the tile, or of the nearest cell that has one.
std::optional<std::size_t> probeNear(const PlacedSector& sector, int x, int z) {
  std::optional<std::size_t> result;
  int nearest = 0;
  for (int k = 0; k < kCells; ++k)
    for (int i = 0; i < kCells; ++i) {
      const std::uint8_t probe = sector.top[static_cast<std::size_t>(i + kCells * k)];
      const int distance = (i - x) * (i - x) + (k - z) * (k - z);
      if (probe == kNoProbe || (result && distance >= nearest)) continue;
      result = probe;
      nearest = distance;
    }
  return result;
}

}  // namespace

std::optional<OcclusionTile> computeOcclusionTile(const PlacedSector& sector,
                                                  const std::vector<double>& sky_visibility) {
  assert(sky_visibility.size() == sector.probe.size());
  OcclusionTile result;
  for (int z = 0; z < kCells; ++z)
    for (int x = 0; x < kCells; ++x) {
      const auto probe = probeNear(sector, x, z);
      if (!probe) return std::nullopt;
      const auto cell = static_cast<std::size_t>(x + kCells * z);
      result.sky_visibility[cell] = sky_visibility[*probe];
      result.probe_y[cell] = sector.probe[*probe].position.y;
    }
  return result;
}

}  // namespace welkin::probes
