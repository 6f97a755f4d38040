// SPDX-License-Identifier: Apache-2.0
// One normal map and its gloss as files of mips, and what was found on the way.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gloss/gloss_source.h"
#include "gloss/integrability.h"
#include "gloss/mips.h"
#include "gloss/normal_map.h"
#include "gloss/write_blocks.h"

namespace welkin::gloss {

enum class Format {
  exr,    ///< floats: normals as they are, components in [-1, 1]; gloss in one channel
  png,    ///< 8 bits: normals as (n + 1)/2
  png16,  ///< 16 bits
  bc3,    ///< one DDS file: x in alpha, y in green, gloss in red
  bc5     ///< DDS files of BC5 for normals and BC4 for gloss
};

/// The steps on one texture.
struct Request {
  std::filesystem::path normal;
  std::string gloss;       ///< a number or a path, as readGloss() takes it
  bool roughness = false;  ///< whether that is roughness
  NormalMapOptions options;
  Wrap wrap = Wrap::repeat;
  bool flip_green = false;
  Format format = Format::exr;
  std::optional<double> max_error_deg;  ///< bc3: largest error of normals under a gloss map (bc3Files)
};

struct WrittenFile {
  std::string name;  ///< within the folder
  std::uint64_t bytes = 0;
  std::string xxh3_128;
};

struct Result {
  std::string normal_name, gloss_name;  ///< as given
  Coding coding = Coding::codes;
  double mean_stored_length = 1.0;
  GreenDirection green;
  std::vector<Mip> mips;
  AverageFactor average;
  std::optional<BlockReport> blocks;
  std::vector<Warning> warnings;
  std::vector<WrittenFile> files;
};

/// Reads the textures, makes the mips and writes NAME_normal_mipK and NAME_gloss_mipK for K from 0 into the folder,
/// which must exist; NAME is the normal map's without its ending. Throws what the steps throw.
Result writeGloss(const Request& request, const std::filesystem::path& folder, const base::Progress& progress = {});

}  // namespace welkin::gloss
