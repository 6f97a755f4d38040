// SPDX-License-Identifier: Apache-2.0
#include "view/user_folder.h"

#include <cstdlib>

namespace welkin::view {
namespace {

namespace fs = std::filesystem;

fs::path folderOf(const char* variable, const char* in_home) {
  const char* named = std::getenv(variable);
  if (named != nullptr && fs::path(named).is_absolute()) return fs::path(named) / "welkin";
  const char* home = std::getenv("HOME");
  if (home == nullptr || !fs::path(home).is_absolute()) return {};
  return fs::path(home) / in_home / "welkin";
}

}  // namespace

fs::path cacheFolder() {
  return folderOf("XDG_CACHE_HOME", ".cache");
}

fs::path configFolder() {
  return folderOf("XDG_CONFIG_HOME", ".config");
}

}  // namespace welkin::view
