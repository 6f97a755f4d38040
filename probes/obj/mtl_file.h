// SPDX-License-Identifier: Apache-2.0
// Reads Wavefront MTL, the materials of OBJ files. "MTL material format", Alias|Wavefront, 1995.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shared.h"

namespace welkin::obj {

/// An image and its placing: its coordinates are scale x (u, v) + offset, with v from the bottom.
struct MtlMap {
  std::string file;  ///< relative to the MTL file, with / as separator; the line's comment is part of it
  double scale[2] = {1.0, 1.0};
  double offset[2] = {0.0, 0.0};
  bool clamped = false;
};

struct MtlMaterial {
  std::string name;
  std::optional<f64::Number3> diffuse;   ///< Kd, linear, in [0, 1]
  std::optional<f64::Number3> emission;  ///< Ke, linear
  double dissolve = 1.0;                 ///< d, or 1 - Tr; 0: invisible
  std::optional<MtlMap> diffuse_map;     ///< map_Kd
  std::optional<MtlMap> emission_map;    ///< map_Ke
  std::string alpha_map;                 ///< map_d; empty: none
};

struct MtlFile {
  std::vector<MtlMaterial> materials;  ///< the first of each name
  std::vector<std::string> warnings;   ///< without the file's name
};

/// Reads Kd, Ke, d, Tr, map_Kd, map_Ke and map_d of every material; keywords may have any case. Throws Error: `file` if
/// the file cannot be read, `content` naming the line.
MtlFile readMtl(const std::filesystem::path& path);

}  // namespace welkin::obj
