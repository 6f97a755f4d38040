// SPDX-License-Identifier: Apache-2.0
// The bake of one sector: surfaces within reach and settings in, its file out. No result of its neighbours takes part.
#pragma once

#include <functional>

#include "probes/build/bake_section.h"
#include "probes/geometry/reach.h"
#include "probes/placement/placement.h"
#include "probes/sectors/sector_file.h"
#include "probes/transfer/light_track.h"
#include "sky/base/progress.h"

namespace welkin::build {

using f64::Number3;

/// Version of the method. It grows by one whenever the same input gives other bytes.
inline constexpr std::uint32_t kBakeVersion = 9;

/// Knots of a light's path that its transfer is traced at, when it is up all day.
inline constexpr int kKnotsADay = 24;

/// Modes of the sun without a budget: with them a probe takes 104 bytes, and further ones give little (docs/probes.md).
inline constexpr std::size_t kSunModes = 10;

/// Paths of a probe under a budget, at most; as many more for its local transfer.
inline constexpr std::size_t kMostPaths = std::size_t{1} << 20;

/// Shares of a budget, whose squares add up to 1 with the encoding's 0.24: of sampling, and of leaving out further
/// modes of the sun.
inline constexpr double kSamplingShare = 0.8;
inline constexpr double kModesShare = 0.55;

/// What a sector's bake is told besides its surfaces.
struct SectorSettings {
  BakeSection section;     ///< as sectionOf gives it, from the sector's corner
  double max_error = 0.0;  ///< that totalOf should keep, for as many rays as it takes; 0: no budget
  Number3 ground_albedo{0.0};
  transfer::LightTrack sun, moon;  ///< without knots where their transfer is not directional
};

/// What a sector's bake reads: the reach of its probes, and that of the eight sectors about it where it gets local
/// transfer, whose virtual lights are their probes.
geometry::Column columnOfBake(geometry::SectorId sector, const TransferSection& transfer,
                              const geometry::Surfaces& level);

/// The settings with those places only that lie within what its bake reads. Their x and z count from the sector's
/// corner, in whole micrometres.
BakeSection sectionOf(geometry::SectorId sector, const BakeSection& level, const geometry::Column& column);

/// `surfaces` is hashAbout the sector. Equal for sectors that hold the same, wherever in the world they are.
sectors::BakedFrom bakedFrom(const base::Hash128& surfaces, const SectorSettings& settings);

/// A sector's file with all that its placement settles, as if the sector were 0_0.
sectors::SectorFile placedFile(const geometry::PlacedSector& placed, const placement::PlacementReport& report,
                               const SectorSettings& settings);

/// The sector is baked as if it were 0_0: `near` as surfacesAbout gives it. So its file is the same but for its number
/// wherever in the world it is.
/// Runs on all threads of the caller's arena; the result is the same for any number of them. Throws Error(interrupted)
/// when told to end, and what placing and tracing throw.
sectors::SectorFile bakeSector(geometry::SectorId sector, const geometry::Surfaces& near,
                               const SectorSettings& settings, const sectors::BakedFrom& from,
                               const base::Progress& progress);

}  // namespace welkin::build
