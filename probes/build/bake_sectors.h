// SPDX-License-Identifier: Apache-2.0
// The bake of a level's sectors into a folder: those that are out of date, and the index.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "probes/build/level_bake.h"
#include "probes/build/shard.h"

namespace welkin::build {

struct LevelOptions {
  std::filesystem::path folder;
  std::optional<Shard> shard;
  std::vector<geometry::SectorId> sectors;      ///< the only ones; empty: all
  bool force = false;                           ///< bake what is up to date as well
  std::vector<sectors::SectorFile> ready = {};  ///< files that a search has baked, of all sectors; empty: none
};

/// Bakes the shard's sectors, or all, or the named ones; then writes the shard's part of the index, or the index, which
/// must wait when a sector that was not asked for is out of date. Adds "sectors" to the report and to its warnings, and
/// what it cost to `timing`. `progress` has a stage "sectors", and within it one of each sector that is baked, whose
/// name is the sector's and whose pieces are rays. Returns the index, if it was written. Throws Error; sectors that
/// were finished before stay.
std::optional<sectors::LevelIndex> bakeSectors(const LevelBake& level, const LevelOptions& options,
                                               const base::Progress& progress, nlohmann::ordered_json& report,
                                               nlohmann::ordered_json& timing);

}  // namespace welkin::build
