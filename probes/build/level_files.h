// SPDX-License-Identifier: Apache-2.0
// The files of a baked level: its index, the shards' parts of it, and whether all is there and agrees.
#pragma once

#include <filesystem>

#include "probes/build/shard.h"
#include "probes/sectors/level_index.h"

namespace welkin::build {

/// DIR/level.welkin, and DIR/level.i-of-n.welkin.
std::filesystem::path indexPath(const std::filesystem::path& folder);
std::filesystem::path partPath(const std::filesystem::path& folder, const Shard& shard);

/// Whether a folder is that of a level: it has an index.
bool isLevelFolder(const std::filesystem::path& folder);

sectors::LevelIndex readIndex(const std::filesystem::path& path);

/// Checks sky.welkin against the index and writes level.welkin. Returns the index with the sky's checksum. Throws
/// Error.
sectors::LevelIndex writeIndex(const std::filesystem::path& folder, sectors::LevelIndex index);

/// Removes sectors' files that the index does not name; a bake makes no others of such names.
void removeOtherSectors(const std::filesystem::path& folder, const sectors::LevelIndex& index);

/// Removes the temporary files of bakes of these skies that were killed. For the owner of the folder's lock.
void removeTemporaries(const std::filesystem::path& folder, const std::vector<std::string>& skies = {"sky"});

/// Removes the parts of shards, all but those of `count` shards.
void removeParts(const std::filesystem::path& folder, std::optional<int> count);

/// Whether every file that the index names is there and is what it says. Throws Error(file) for one that is missing,
/// Error(content) for one that is another.
void checkLevel(const std::filesystem::path& folder, const sectors::LevelIndex& index);

/// Makes the index of the shards' parts, and one report of theirs; removes sectors of an earlier bake. Throws Error:
/// content where they do not agree, file where one is missing or a bake is at work.
sectors::LevelIndex mergeParts(const std::filesystem::path& folder);

}  // namespace welkin::build
