// SPDX-License-Identifier: Apache-2.0
// A probe's transfer of distant light: the radiance transfer of the sky and of the sun.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "probes/transfer/transfer_basis.h"

namespace welkin::transfer {

using f64::Number3;

/// Transfer of one probe, by direction of the transfer basis. Values are irradiance, pi included.
struct ProbeTransfer {
  /// Unoccluded share of a uniform upper hemisphere's irradiance: 1 in the open, 0 for down. Glass counts by the share
  /// that it passes of every channel.
  std::array<double, kDirections> visibility{};
  /// Bounced irradiance by distant light of radiance Y_k in the upper hemisphere, and the colour of what comes through
  /// glass: [direction][coefficient].
  std::array<std::array<Number3, 4>, kDirections> sky{};
  /// Bounced irradiance by a light of normal irradiance 1 in the direction of each of
  /// TransferSettings::light_directions: [direction][i].
  std::array<std::vector<Number3>, kDirections> sun;
  /// Irradiance by emissive surfaces, direct and bounced, and by the level's own lights, bounced.
  std::array<Number3, kDirections> emitted{};
};

/// Whether no light reaches the probe at all, as in a closed room.
inline bool isUnlit(const ProbeTransfer& t) {
  const auto none = [](const auto& light) {
    return std::all_of(light.begin(), light.end(), [](const Number3& e) { return e == Number3(0.0); });
  };
  for (std::size_t b = 0; b < kDirections; ++b)
    if (t.visibility[b] > 0.0 || !none(t.sky[b]) || !none(t.sun[b])) return false;
  return none(t.emitted);
}

/// Cost and error of a probe's transfer.
struct TransferEffort {
  std::size_t paths = 0;
  std::uint64_t rays = 0;  ///< path segments and light tests
  /// Standard error of the irradiance under a uniform sky of radiance 1, direct and bounced.
  std::array<Number3, kDirections> sky_error{};
  /// Standard error of the irradiance by a light of normal irradiance 1: for each direction, the worst channel and
  /// light.
  std::array<double, kDirections> sun_error{};
  /// Half the 95 % confidence interval, the worse of two. The sky's is relative to its open-field irradiance, pi. The
  /// light's is relative to that of the highest light, the sine of its elevation.
  double error = 0.0;
};

struct TracedProbe {
  ProbeTransfer transfer;
  TransferEffort effort;
};

}  // namespace welkin::transfer
