// SPDX-License-Identifier: Apache-2.0
#include "probes/sectors/occlusion_tile.h"

#include <algorithm>

namespace welkin::sectors {
namespace {

/// The share of a uniform sky that a horizontal surface sees, from the probe's visibilities.
double horizontalShare(const transfer::ProbeTransfer& transfer) {
  const auto basis = transfer::transferBasis();
  const auto weight = transfer::shadingWeights({0, 1, 0});
  double share = 0.0;
  for (std::size_t b = 0; b < transfer::kDirections; ++b)
    share += weight[b] * transfer.visibility[b] * (1.0 + basis[b].y) / 2.0;
  return std::clamp(share, 0.0, 1.0);
}

}  // namespace

std::optional<OcclusionTile> occlusionTileOf(const std::array<std::uint8_t, geometry::kCells * geometry::kCells>& top,
                                             const transfer::SectorProbes& probes) {
  if (probes.position.empty()) return std::nullopt;
  OcclusionTile tile;
  for (std::size_t i = 0; i < top.size(); ++i) {
    tile.sky_visibility[i] = horizontalShare(probes.transfer.at(top[i]));
    tile.probe_y[i] = probes.position.at(top[i]).y;
  }
  return tile;
}

}  // namespace welkin::sectors
