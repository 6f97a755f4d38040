// SPDX-License-Identifier: Apache-2.0
// Where the files of a user are kept, by the XDG Base Directory Specification 0.8.
#pragma once

#include <filesystem>

namespace welkin::view {

/// XDG_CACHE_HOME/welkin, or .cache/welkin in the home folder. Empty without a home; a relative path in the variable
/// is ignored, as the specification says.
std::filesystem::path cacheFolder();

/// XDG_CONFIG_HOME/welkin, or .config/welkin in the home folder; likewise.
std::filesystem::path configFolder();

}  // namespace welkin::view
