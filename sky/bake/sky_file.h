// SPDX-License-Identifier: Apache-2.0
// Reads sky.toml, the artist's file. docs/sky_file.md describes every key.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "sky/bake/bake_settings.h"
#include "sky/base/toml_file.h"
#include "sky/model/path_check.h"
#include "sky/model/sky.h"

namespace welkin::bake {

/// A file that was read: its name as written in sky.toml and its XXH3-128. The name of sky.toml itself has no folders,
/// and its hash is that of its settings as JSON.
struct Input {
  std::string name;
  std::filesystem::path path;
  std::uint64_t xxh3_low = 0;
  std::uint64_t xxh3_high = 0;
};

Input inputOf(const std::string& name, const std::filesystem::path& path, std::span<const std::byte> bytes);

struct SkyFile {
  std::string name = "sky";  ///< of the outputs: NAME.welkin, NAME.json, cubemaps/NAME_HHMMSSmmm.exr
  model::Sky sky;
  BakeSettings bake;
  std::string settings;  ///< sky.toml as JSON, keys sorted
  std::vector<Input> inputs;
  std::vector<Input> family;             ///< inputs of the other skies that share its modes; empty for a sky alone
  std::vector<model::Warning> warnings;  ///< each message begins with sky.toml's name, without folders, and the line
};

/// Checks a sky file and reads the images that it names, relative to it. Throws Error.
SkyFile skyFileOf(const base::TomlFile& toml);
/// The same for a file that is still to be read.
SkyFile readSkyFile(const std::filesystem::path& path);

}  // namespace welkin::bake
