// SPDX-License-Identifier: Apache-2.0
// The bake of a level, sector by sector: which there are, which of their files are out of date and why, and each one's
// bake.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "probes/build/sector_bake.h"
#include "probes/level_index.h"
#include "probes/placement/checkpoint.h"
#include "sky/sky.h"

namespace welkin::probes {

/// DIR/sectors/sector_X_Z.welkin
std::filesystem::path sectorPath(const std::filesystem::path& folder, SectorId sector);

/// What a bake finds in a sector's place.
struct SectorState {
  SectorId id;
  BakedFrom from;                  ///< what the sector must be baked from
  std::optional<SectorFile> file;  ///< that is there, if it can be read
  std::string stale;               ///< why it is to be baked; empty: it is up to date
  std::vector<std::byte> bytes;    ///< of the file, when it is up to date
};

/// What a sector will have.
struct SectorPlan {
  std::size_t probes = 0;
  bool has_local = false;  ///< local transfer
};

/// Immutable after construction.
class LevelBake {
 public:
  /// `max_error`: the budget of rays = "auto". Emission and lights, which come in cd/m2 and cd, are taken over
  /// `sky.luminance_unit`. Throws Error(content) where rays = "auto" has no budget below 1, and what sectorsOf and the
  /// checkpoint throw.
  LevelBake(Surfaces surfaces, const BakeSection& section, const sky::Sky& sky, std::optional<double> max_error,
            const Checkpoint& checkpoint = {});

  /// Ascending.
  const std::vector<SectorId>& sectors() const { return sectors_; }

  /// The state of a sector's file under `folder`.
  SectorState state(const std::filesystem::path& folder, SectorId sector) const;

  /// Throws as bakeSector.
  SectorFile bake(SectorId sector, const BakeProgress& progress) const;

  /// Places a sector's probes to say how many. Throws what placeSector throws.
  SectorPlan plan(SectorId sector, const Checkpoint& checkpoint = {}) const;

  /// The error that rays = "auto" has to keep; none where the number of rays is fixed.
  std::optional<double> budget() const;

  /// The sector as placement leaves it, and the level itself: for pictures.
  PlacedSector place(SectorId sector, const Checkpoint& checkpoint = {}) const;
  const Surfaces& surfaces() const { return surfaces_; }

  /// The index without its sectors and the sky's checksum.
  LevelIndex index() const;

 private:
  Column columnOfBake(SectorId sector) const;
  SectorSettings settingsOf(SectorId sector) const;

  Surfaces surfaces_;
  BakeSection section_;
  double max_error_ = 0.0;
  Number3 ground_albedo_{0.0};
  sky::LightPath sun_path_;
  std::optional<sky::LightPath> moon_path_;
  LightTrack sun_, moon_;
  std::vector<Hash128> texture_hash_;
  std::vector<SectorId> sectors_;
};

/// The entry of a sector's file.
SectorEntry entryOf(const SectorFile& file, std::span<const std::byte> bytes);

}  // namespace welkin::probes
