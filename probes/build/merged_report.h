// SPDX-License-Identifier: Apache-2.0
// The report of a level that shards have baked, of theirs.
#pragma once

#include <filesystem>
#include <optional>

#include "probes/build/shard.h"
#include "probes/sectors/level_index.h"

namespace welkin::build {

/// DIR/report.json, or of a shard DIR/report.i-of-n.json; timing.json alike.
std::filesystem::path reportPath(const std::filesystem::path& folder, const std::optional<Shard>& shard);
std::filesystem::path timingPath(const std::filesystem::path& folder, const std::optional<Shard>& shard);

/// The report of an earlier bake of all of a folder; nothing where there is none that can be read.
std::optional<nlohmann::ordered_json> earlierReport(const std::filesystem::path& folder);

/// The level file of the last bake, as its timing.json names it, seen from the folder. Not in report.json, whose bytes
/// are the same wherever a level lies.
std::optional<std::string> levelOfBake(const std::filesystem::path& folder);

/// Writes the report that one process would have written, of those of `count` shards; where one of them is not in the
/// folder, or of other sectors than the index, none. What an earlier bake by one process has left is removed, and
/// timing.json names the level file alone. Throws Error(content) for a file that is no report.
void mergeReports(const std::filesystem::path& folder, int count, const sectors::LevelIndex& index);

}  // namespace welkin::build
