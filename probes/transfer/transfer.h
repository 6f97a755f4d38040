// SPDX-License-Identifier: Apache-2.0
// What a probe gets of the distant light: the radiance transfer of the sky and of the sun.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "probes/transfer/transfer_basis.h"

namespace welkin::transfer {

using f64::Number3;

/// Transfer of one probe, by direction of the transfer basis. Irradiance, pi included.
struct ProbeTransfer {
  /// Share of a uniform upper hemisphere's irradiance that is not occluded; 1 in the open, 0 for down.
  std::array<double, kDirections> visibility{};
  /// Bounced irradiance of distant light with radiance Y_k (upper hemisphere): [direction][coefficient].
  std::array<std::array<Number3, 4>, kDirections> sky{};
  /// Bounced irradiance of a light of normal irradiance 1 in the direction of each of
  /// TransferSettings::light_directions: [direction][i].
  std::array<std::vector<Number3>, kDirections> sun;
  /// Irradiance of emissive surfaces, direct and bounced.
  std::array<Number3, kDirections> emitted{};
};

/// What a probe's transfer took, and how sure it is.
struct TransferEffort {
  std::size_t paths = 0;
  std::uint64_t rays = 0;  ///< segments of paths and tests of lights
  /// Standard error of the irradiance under a uniform sky of radiance 1, direct and bounced.
  std::array<Number3, kDirections> sky_error{};
  /// Standard error of the irradiance of a light of normal irradiance 1: of each direction the worst channel and light.
  std::array<double, kDirections> sun_error{};
  /// Half the 95 % confidence interval: the worse of the sky's over its open-field irradiance pi and the light's over
  /// that of the highest light, 1 times the sine of its elevation.
  double error = 0.0;
};

struct TracedProbe {
  ProbeTransfer transfer;
  TransferEffort effort;
};

}  // namespace welkin::transfer
