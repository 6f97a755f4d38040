// SPDX-License-Identifier: Apache-2.0
// Reads level.toml: the sky and the geometry of a level.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "probes/geometry/affine.h"
#include "probes/geometry/surfaces.h"
#include "probes/level/outside_files.h"
#include "sky/base/toml_file.h"

namespace welkin::level {

/// The role with a given name ("static", "vegetation", "water", "ignore"); nothing for another name.
std::optional<geometry::Role> roleOf(const std::string& name);

/// One [[geometry]] entry.
struct GeometryEntry {
  std::filesystem::path path;  ///< includes level.toml's folder
  geometry::Affine transform;
  geometry::Role role = geometry::Role::fixed;
  std::vector<std::string> vegetation_nodes;  ///< patterns of node names; * stands for any run of characters
  std::vector<std::string> ignore_nodes{};    ///< patterns of nodes that are left out with all below them
  f64::Number3 albedo{0.5, 0.5, 0.5};         ///< for surfaces with neither a material nor vertex colours
};

struct LevelFile {
  std::filesystem::path sky;
  std::vector<std::filesystem::path> more_skies;  ///< further ones of its family
  std::vector<GeometryEntry> geometry;
  std::filesystem::path folder;  ///< of level.toml; empty: unknown, and no file is outside of it
  OutsideFiles outside_files = OutsideFiles::warn;
};

/// Reads and checks [level] and [[geometry]]. It ignores [probes], [[room]], [transfer], [bake] and [scale], which
/// belong to the bake (bake_section.h). Throws Error(content) if they are wrong.
LevelFile levelFileOf(const base::TomlFile& toml);

}  // namespace welkin::level
