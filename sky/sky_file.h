// SPDX-License-Identifier: Apache-2.0
// sky.toml: what an artist writes. docs/sky_file.md describes every key.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "format/cubemap_format.h"
#include "sky/path_check.h"
#include "sky/sky.h"

namespace welkin::sky {

/// The [bake] section.
struct BakeSettings {
  int bands = 2;
  std::vector<double> key_time_h;
  int cubemap_size = 128;  ///< 0: none
  std::vector<double> cubemap_time_h;
  format::CubemapFormat cubemap_format = format::CubemapFormat::rgba16f;
};

/// A file that was read: its name as written in sky.toml (sky.toml's own name without folders) and XXH3-128.
struct Input {
  std::string name;
  std::filesystem::path path;
  std::uint64_t xxh3_low = 0;
  std::uint64_t xxh3_high = 0;
};

struct SkyFile {
  Sky sky;
  BakeSettings bake;
  std::string settings;  ///< sky.toml as JSON, keys sorted
  std::vector<Input> inputs;
  std::vector<Warning> warnings;  ///< messages begin with sky.toml's name, without folders, and the line
};

/// Keys of a table with keys = "auto": one every five minutes.
inline constexpr int kAutoKeys = 288;

/// The whole millisecond of the day, 0 to 86399999, that names the cubemap of a time in [0, 24).
long millisecondOf(double time_h);

/// Reads and checks a sky file and the images it names (relative to it). Throws Error.
SkyFile readSkyFile(const std::filesystem::path& path);

}  // namespace welkin::sky
