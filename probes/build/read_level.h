// SPDX-License-Identifier: Apache-2.0
// A level as its bake reads it.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "probes/build/level_bake.h"

namespace welkin::build {

/// The geometry that a level was read from, for its bake and for a make rule.
struct LevelInput {
  LevelBake bake;
  std::vector<std::filesystem::path> files;
  std::vector<std::string> warnings;
};

/// Reads level.toml's geometry and settings. `max_error` is for rays = "auto". Throws Error.
LevelInput readLevel(const std::filesystem::path& level, const model::Sky& sky, std::optional<double> max_error,
                     const base::Progress& progress);

/// Adds the warnings of the level as a whole: features of its files that have no effect, and that it has no sector.
void addLevelWarnings(const LevelInput& level, nlohmann::ordered_json& warnings);

}  // namespace welkin::build
