// SPDX-License-Identifier: Apache-2.0
// Whether the files of a bake's folder are whole and of one bake.
#pragma once

#include <filesystem>

namespace welkin::build {

/// Compares every file of a folder with each checksum that is recorded of it: by sky.json, by the level's index, and by
/// report.json. A folder may lack any of these three. Throws Error: content for a file that is damaged or of another
/// bake, file for one that is missing.
void checkFolder(const std::filesystem::path& folder);

}  // namespace welkin::build
