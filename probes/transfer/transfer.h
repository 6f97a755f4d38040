// SPDX-License-Identifier: Apache-2.0
// What a probe gets of the distant light: the radiance transfer of the sky and of the sun.
#pragma once

#include <array>
#include <vector>

#include "probes/transfer_basis.h"

namespace welkin::probes {

/// Transfer of one probe, by direction of the transfer basis. Irradiance, pi included.
struct ProbeTransfer {
  /// Share of a uniform upper hemisphere's irradiance that is not occluded; 1 in the open, 0 for down.
  std::array<double, kDirections> visibility{};
  /// Bounced irradiance of distant light with radiance Y_k (upper hemisphere): [direction][coefficient].
  std::array<std::array<Number3, 4>, kDirections> sky{};
  /// Bounced irradiance of a light of normal irradiance 1 in the direction of each of LightDirections: [direction][i].
  std::array<std::vector<Number3>, kDirections> sun;
  /// Irradiance of emissive surfaces, direct and bounced.
  std::array<Number3, kDirections> emitted{};
};

}  // namespace welkin::probes
