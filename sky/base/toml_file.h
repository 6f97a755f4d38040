// SPDX-License-Identifier: Apache-2.0
// A TOML file as it was read.
#pragma once

#include <toml++/toml.h>

#include <cstddef>
#include <filesystem>
#include <vector>

namespace welkin::base {

inline constexpr std::size_t kLargestTomlFile = std::size_t{16} << 20;  ///< limit, bytes

struct TomlFile {
  std::filesystem::path path;
  std::vector<std::byte> bytes;
  toml::table root;
};

/// Throws Error: `file` if the file cannot be read, `content` if it is larger than kLargestTomlFile or not TOML.
TomlFile readToml(const std::filesystem::path& path);

}  // namespace welkin::base
