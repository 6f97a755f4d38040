// SPDX-License-Identifier: Apache-2.0
#include "probes/sectors/occlusion_tile.h"

#include <algorithm>
#include <cmath>

#include "probes/transfer/relight.h"
#include "shared.h"

namespace welkin::sectors {
namespace {

/// The share of a uniform sky's light that a horizontal surface has, direct and bounced.
double horizontalShare(const transfer::ProbeTransfer& transfer) {
  transfer::Relight light;  // radiance 1 over the upper hemisphere
  light.sky[0] = f64::Number3(std::sqrt(f64::kPi));
  light.sky[1] = f64::Number3(std::sqrt(3.0 * f64::kPi) / 2.0);
  light.bounced_sky = light.sky;
  const auto irradiance = transfer::relit(transfer, {}, light).sky;
  const auto weight = transfer::shadingWeights({0, 1, 0});
  f64::Number3 sum(0.0);
  for (std::size_t b = 0; b < transfer::kDirections; ++b) sum += irradiance[b] * weight[b];
  return std::clamp(f64::luminanceOf(sum) / f64::kPi, 0.0, 1.0);
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
