// SPDX-License-Identifier: Apache-2.0
// The plan of one sector: its probes are placed, and nothing is traced.
#pragma once

#include <optional>

#include "probes/build/sector_bake.h"

namespace welkin::build {

struct SectorPlan {
  std::size_t probes = 0;
  bool has_local = false;  ///< local transfer
  /// Estimate of the file's bytes: up to a hundred too few, because FlatBuffers stores no field that is 0, and without
  /// cuts. It counts kSunModes modes of the sun. The bake makes fewer where a sun stands still, and as many as a budget
  /// takes. Emitted light counts where an emissive surface is within reach, local transfer with its upper limit.
  std::size_t bytes = 0;
  /// The rays that the bake traces after placement, at most; nothing where rays = "auto" takes as many as the budget
  /// needs.
  std::optional<std::uint64_t> rays;
};

/// Throws what placeSector throws. Arguments as for bakeSector; `level` decides on local transfer.
SectorPlan planSector(geometry::SectorId sector, const geometry::Surfaces& near, const geometry::Surfaces& level,
                      const SectorSettings& settings, const base::Progress& progress);

}  // namespace welkin::build
