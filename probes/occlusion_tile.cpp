// SPDX-License-Identifier: Apache-2.0
#include "probes/occlusion_tile.h"

#include <algorithm>

namespace welkin::probes {
namespace {

/// Of a uniform sky, what a level surface sees by the probe's visibilities.
double horizontalShare(const ProbeTransfer& transfer) {
  const auto basis = transferBasis();
  const auto weight = shadingWeights({0, 1, 0});
  double share = 0.0;
  for (std::size_t b = 0; b < kDirections; ++b) share += weight[b] * transfer.visibility[b] * (1.0 + basis[b].y) / 2.0;
  return std::clamp(share, 0.0, 1.0);
}

}  // namespace

std::optional<OcclusionTile> occlusionTileOf(const std::array<std::uint8_t, kCells * kCells>& top,
                                             const SectorProbes& probes) {
  if (probes.position.empty()) return std::nullopt;
  OcclusionTile tile;
  for (std::size_t i = 0; i < top.size(); ++i) {
    tile.sky_visibility[i] = horizontalShare(probes.transfer.at(top[i]));
    tile.probe_y[i] = probes.position.at(top[i]).y;
  }
  return tile;
}

}  // namespace welkin::probes
