// SPDX-License-Identifier: Apache-2.0
// The bake of a level's sectors into a folder: those that are out of date, and the index.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "command/progress.h"
#include "command/shard.h"
#include "probes/build/level_bake.h"

namespace welkin::command {

/// The geometry that a level was read from, for its bake and for a make rule.
struct LevelInput {
  build::LevelBake bake;
  std::vector<std::filesystem::path> files;
  std::vector<std::string> warnings;
};

/// Throws Error(interrupted) where someone asked the program to stop.
void endIfInterrupted();

/// Reads level.toml's geometry and settings. `max_error` is for rays = "auto". Throws Error.
LevelInput readLevel(const std::filesystem::path& level, const model::Sky& sky, std::optional<double> max_error);

/// What its files hold that has no effect, and whether nothing of it is baked.
void addLevelWarnings(const LevelInput& level, nlohmann::ordered_json& warnings);

struct LevelOptions {
  std::filesystem::path folder;
  std::optional<Shard> shard;
  std::vector<geometry::SectorId> sectors;  ///< the only ones; empty: all
  bool force = false;                       ///< bake what is up to date as well
};

/// Bakes the shard's sectors, or all, or the named ones; then writes the shard's part of the index, or the index, which
/// must wait when a sector that was not asked for is out of date. Adds "sectors" to the report and to its warnings, and
/// what it cost to `timing`. Throws Error; sectors that were finished before stay.
void bakeSectors(const LevelInput& level, const LevelOptions& options, ProgressReport::Style style,
                 nlohmann::ordered_json& report, nlohmann::ordered_json& timing);

}  // namespace welkin::command
