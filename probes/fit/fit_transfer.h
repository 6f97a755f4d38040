// SPDX-License-Identifier: Apache-2.0
// Fits the transfer of a sector's probes to the light of surfaces and of the air, through the runtime's own look-up.
// Light is linear in the transfer, and the look-up is a fixed linear map from probes to points. So least squares find
// the probes' numbers that light the points best, for no byte and no instruction more at run time. After Iwanicki and
// Sloan, "Precomputed Lighting in Call of Duty: Infinite Warfare" (SIGGRAPH 2017).
#pragma once

#include <span>

#include "probes/fit/look_up.h"
#include "probes/transfer/trace_transfer.h"

namespace welkin::fit {

struct FitSettings {
  std::size_t surface_points = 16;  ///< a probe
  std::size_t air_points = 12;      ///< a probe
  std::uint32_t paths = 128;        ///< a point
  double pull = 0.1;                ///< to what was traced, as NormalMatrix has it
};

struct FitReport {
  std::size_t points = 0;
  std::size_t surface_without = 0;  ///< points of surfaces that no probe of the sector serves; they are not fitted
  std::uint64_t rays = 0;
};

/// Replaces the transfer of a sector's probes, as if it were 0_0. A point near the sector's border counts by the square
/// of the share that its look-up gives to these probes, and is wanted to have its light from them alone. So no result
/// of a neighbour takes part. Runs on all threads of the caller's arena; the result is the same for any number of them.
FitReport fitTransfer(const geometry::Tracer& tracer, const geometry::PlacedSector& sector,
                      const placement::SectorCuts& cuts, const transfer::TransferSettings& settings,
                      std::span<transfer::ProbeTransfer* const> probes, const base::Progress& progress = {},
                      const FitSettings& fit = {});

}  // namespace welkin::fit
