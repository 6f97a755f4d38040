// SPDX-License-Identifier: Apache-2.0
// The input of a bake: a sky, or a level with its sky. Every file of it is read once.
#pragma once

#include <optional>
#include <vector>

#include "probes/build/bake_section.h"
#include "probes/geometry/surfaces.h"
#include "sky/bake/sky_file.h"

namespace welkin::build {

/// Smoother surfaces, and those as smooth, reflect the sky in a way that cubemaps show. Rougher ones see little but its
/// irradiance.
inline constexpr double kReflectiveRoughness = 0.5;

/// A level as its files describe it.
struct Level {
  BakeSection section;
  geometry::Surfaces surfaces;  ///< emission and lights in scene units
};

struct Subject {
  bake::SkyFile sky;                ///< without cubemaps for a level where nothing reflects, unless it asks for some
  std::vector<bake::SkyFile> more;  ///< further skies of its family
  std::vector<bake::Input> inputs;  ///< those of the skies, then level.toml and its geometry
  std::optional<Level> level;
};

/// Reads a sky file or a level file, told apart by their sections; `more` are further sky files, of a family. Throws
/// Error.
Subject readSubject(const std::filesystem::path& path, const std::vector<std::filesystem::path>& more = {});

/// Reads a level file and all that it names. Throws Error.
Subject readLevel(const std::filesystem::path& path);

}  // namespace welkin::build
