// SPDX-License-Identifier: Apache-2.0
// The sections of level.toml for its bake: [probes], [[room]], [transfer], [bake] and [scale]. docs/level_file.md
// describes every key.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "probes/placement/settings.h"
#include "probes/transfer/relight.h"
#include "sky/base/toml_file.h"

namespace welkin::build {

/// The name in level.toml.
const char* nameOf(transfer::SunTransfer sun);

/// Where dynamic lights are provided for: near lights of the level, everywhere or nowhere, or in these sectors.
struct LocalLights {
  enum class Where { near_lights, everywhere, nowhere, listed } where = Where::near_lights;
  std::vector<geometry::SectorId> sector;  ///< ascending
};

/// What decides the transfer of a sector's probes.
enum class Fit {
  surfaces,  ///< the light of surfaces and of the air, through the runtime's look-up (probes/fit)
  none       ///< the light at the probes' own places, as in Stefanov's talk
};

struct TransferSection {
  std::optional<int> rays = 1024;  ///< none: as many as the budget takes
  int bounces = 2;
  transfer::SunTransfer sun = transfer::SunTransfer::directional;
  LocalLights local_lights;
  double reach_m = 128.0;
  Fit fit = Fit::surfaces;
};

struct BakeSection {
  placement::PlacementSettings probes;  ///< [probes] and [[room]]
  TransferSection transfer;
  transfer::RelightScale scale;  ///< the runtime may change it
  /// [bake]: the error on surfaces and in the air that a sector gets enough probes for; none: distances as stated.
  std::optional<double> max_surface_error;
};

/// Reads and checks these sections of a level file. An absent key has its default. Throws Error(content).
BakeSection bakeSectionOf(const base::TomlFile& toml);

/// The settings as JSON for the baked files: keys in a fixed order, without the scales.
std::string settingsText(const BakeSection& section);

}  // namespace welkin::build
