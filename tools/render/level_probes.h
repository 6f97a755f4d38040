// SPDX-License-Identifier: Apache-2.0
// The probes of a baked level, relit for a time of day, for the level picture.
#pragma once

#include <filesystem>
#include <vector>

#include "probes/sectors/level_light.h"
#include "render/probe_sphere.h"
#include "sky/base/toml_file.h"

namespace welkin::render {

class LevelProbes {
 public:
  /// Reads the level's sky and [scale], and every sector_X_Z.welkin in DIR/sectors, in the order of the sectors. Throws
  /// Error(file) when the folder or a file cannot be read, or there is no sector. Throws Error(content) when a sector
  /// is damaged or does not match its name.
  LevelProbes(const base::TomlFile& level, const std::filesystem::path& folder);

  /// The probes at a finite time in hours, lit by sky, bounced sun and moon, and emission, with the level's [scale].
  std::vector<ProbeSphere> at(double time_h) const;

 private:
  model::Sky sky_;
  transfer::RelightScale scale_;
  std::vector<sectors::SectorFile> sectors_;
};

}  // namespace welkin::render
