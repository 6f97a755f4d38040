// SPDX-License-Identifier: Apache-2.0
// The error that encoding adds to the irradiance of a sector's probes.
#pragma once

#include "probes/transfer/encoding.h"

namespace welkin::transfer {

/// The largest differences between probes and their decoded copies.
struct EncodingError {
  double position_m = 0.0;  ///< of one coordinate
  double visibility = 0.0;
  /// Bound of the error of bounced irradiance in one direction and channel, under any sky whose radiance is 0 to 1
  /// everywhere. It is relative to pi, the irradiance of open ground under a sky of radiance 1, as in
  /// TransferEffort::error.
  double sky = 0.0;
  double sun = 0.0;      ///< irradiance at a knot by a light of normal irradiance 1, clamped at 0
  double emitted = 0.0;  ///< irradiance, relative to the probe's largest
};

/// Compares the two. `decoded` must have the places, modes and knots of `probes`.
EncodingError encodingError(const SectorProbes& probes, const SectorProbes& decoded);

}  // namespace welkin::transfer
