// SPDX-License-Identifier: Apache-2.0
// What a bake is asked for: a sky, or a level, whose sky is baked with what the level requires.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "sky/bake/sky_file.h"

namespace welkin::build {

/// Surfaces as smooth as this reflect the sky in a way that cubemaps show; rougher ones see little but its irradiance.
inline constexpr double kReflectiveRoughness = 0.5;

struct Subject {
  bake::SkyFile sky;
  bool nothing_reflects = false;  ///< a level without a surface of kReflectiveRoughness or less: no cubemaps then,
                                  ///< unless the sky file asks for some
  std::optional<std::filesystem::path> level = std::nullopt;  ///< the level file, where it is one
  std::vector<bake::Input> level_inputs{};  ///< it and its geometry, of which sky.welkin holds nothing

  /// What was read: of the sky, then of the level.
  std::vector<bake::Input> inputs() const;
};

/// Reads a sky file or a level file, told apart by their sections. Throws Error.
Subject readSubject(const std::filesystem::path& path);

}  // namespace welkin::build
