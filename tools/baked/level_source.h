// SPDX-License-Identifier: Apache-2.0
// The level.toml that a folder was baked from.
#pragma once

#include <filesystem>
#include <string>

namespace welkin::baked {

struct LevelSource {
  std::filesystem::path file;
  std::string warning;  ///< where the file's bytes are not those that were baked; else empty
};

/// `given`, or else the file that the last bake of the level's folder read (timing.json), level.toml in the folder, or
/// beside it. Throws Error(file) that says where it was looked for.
LevelSource levelSource(const std::filesystem::path& folder, const std::filesystem::path& given);

}  // namespace welkin::baked
