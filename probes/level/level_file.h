// SPDX-License-Identifier: Apache-2.0
// level.toml: the sky and the geometry of a level.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "probes/geometry/affine.h"
#include "probes/geometry/surfaces.h"

namespace welkin::level {

inline constexpr std::size_t kLargestLevelFile = std::size_t{16} << 20;  ///< bytes of level.toml

/// The role of its name ("static", "vegetation", "water", "ignore"); nothing for another name.
std::optional<geometry::Role> roleOf(const std::string& name);

/// One [[geometry]].
struct GeometryEntry {
  std::filesystem::path path;  ///< level.toml's folder is in it
  geometry::Affine transform;
  geometry::Role role = geometry::Role::fixed;
  std::vector<std::string> vegetation_nodes;  ///< patterns of node names: * stands for any run of characters
  f64::Number3 albedo{0.5, 0.5, 0.5};         ///< of surfaces that have neither a material nor vertex colours
};

struct LevelFile {
  std::filesystem::path sky;
  std::vector<GeometryEntry> geometry;
};

/// Reads and checks [level] and [[geometry]]; [probes], [[room]], [transfer] and [scale] are the bake's
/// (bake_section.h) and are left alone. Throws Error: `file` for a file that cannot be read, `content` for what it
/// holds.
LevelFile readLevelFile(const std::filesystem::path& path);

}  // namespace welkin::level
