// SPDX-License-Identifier: Apache-2.0
// What encoding the probes of a sector does to their irradiance.
#pragma once

#include "probes/transfer/encoding.h"

namespace welkin::transfer {

/// The worst difference between probes and what became of them.
struct EncodingError {
  double position_m = 0.0;  ///< of a component
  double visibility = 0.0;
  /// Bound of the bounced irradiance's, of a direction and channel, under any sky of radiance 0 to 1 everywhere; over
  /// pi, the irradiance of open ground under the sky of radiance 1. So that TransferEffort::error can be compared with
  /// it.
  double sky = 0.0;
  double sun = 0.0;      ///< irradiance, at a knot, of a light of normal irradiance 1, clamped at 0
  double emitted = 0.0;  ///< irradiance, over the probe's largest
};

/// `decoded` has the places, modes and knots of `probes`.
EncodingError encodingError(const SectorProbes& probes, const SectorProbes& decoded);

}  // namespace welkin::transfer
