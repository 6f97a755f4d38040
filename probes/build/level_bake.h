// SPDX-License-Identifier: Apache-2.0
// The bake of a level: its sectors, the state of each one's file, and each one's plan and bake.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "probes/build/sector_plan.h"
#include "probes/sectors/level_index.h"
#include "sky/base/progress.h"
#include "sky/model/sky.h"

namespace welkin::build {

using f64::Number3;

/// DIR/sectors/sector_X_Z.welkin
std::filesystem::path sectorPath(const std::filesystem::path& folder, geometry::SectorId sector);

/// The state of a sector's file before a bake.
struct SectorState {
  geometry::SectorId id;
  sectors::BakedFrom from;                  ///< hashes that the file must have
  std::optional<sectors::SectorFile> file;  ///< the present file, if it can be read
  std::string stale;                        ///< why the sector is to be baked; empty: it is up to date
  std::vector<std::byte> bytes;             ///< of the file, when it is up to date
};

/// Immutable after construction, but for the spreads.
class LevelBake {
 public:
  /// `surfaces` has emission and lights in scene units. `max_error` is the budget of rays = "auto". Throws
  /// Error(content) where rays = "auto" has no budget below 1, and what sectorsOf and the progress throw.
  LevelBake(geometry::Surfaces surfaces, const BakeSection& section, const model::Sky& sky,
            std::optional<double> max_error, const base::Progress& progress = {});

  /// Ascending.
  const std::vector<geometry::SectorId>& sectors() const { return sectors_; }

  /// The state of a sector's file under `folder`.
  SectorState state(const std::filesystem::path& folder, geometry::SectorId sector) const;

  /// Throws as bakeSector. A `spread` stands for the sector's own.
  sectors::SectorFile bake(geometry::SectorId sector, const base::Progress& progress,
                           std::optional<double> spread = std::nullopt) const;

  /// Factors of the distances between probes, by sector; 1 until they are set. Before any sector is baked.
  void setSpreads(std::vector<double> spread) { spread_ = std::move(spread); }

  /// Throws as planSector.
  SectorPlan plan(geometry::SectorId sector, const base::Progress& progress = {}) const;

  /// The error that rays = "auto" has to keep; none where the number of rays is fixed.
  std::optional<double> budget() const;

  /// The error on surfaces and in the air that the level has to keep.
  std::optional<double> surfaceBudget() const { return section_.max_surface_error; }

  /// The sector as placement leaves it, and the level itself: for pictures.
  geometry::PlacedSector place(geometry::SectorId sector, const base::Progress& progress = {}) const;
  const geometry::Surfaces& surfaces() const { return surfaces_; }

  /// Bounces of a path, and paths of a probe; with a budget, those of the default.
  int bounces() const { return section_.transfer.bounces; }
  std::size_t raysOfProbe() const {
    return static_cast<std::size_t>(section_.transfer.rays.value_or(*TransferSection{}.rays));
  }

  /// A hash of all triangles with their materials and textures.
  base::Hash128 geometryHash() const;

  /// The index without its sectors and the sky's checksum.
  sectors::LevelIndex index() const;

 private:
  geometry::Column columnOfBake(geometry::SectorId sector) const;
  sectors::BakedFrom bakedFrom(geometry::SectorId sector, double spread) const;
  SectorSettings settingsOf(geometry::SectorId sector, double spread) const;
  double spreadOf(geometry::SectorId sector) const;

  geometry::Surfaces surfaces_;
  BakeSection section_;
  double max_error_ = 0.0;
  Number3 ground_albedo_{0.0};
  model::LightPath sun_path_;
  std::optional<model::LightPath> moon_path_;
  transfer::LightTrack sun_, moon_;
  std::vector<base::Hash128> content_;  // by triangle
  std::vector<geometry::SectorId> sectors_;
  std::vector<double> spread_;  // by sector; empty: 1
};

/// The entry of a sector's file.
sectors::SectorEntry entryOf(const sectors::SectorFile& file, std::span<const std::byte> bytes);

}  // namespace welkin::build
