// SPDX-License-Identifier: Apache-2.0
// The probes of a baked level, relit for a time, as the level picture draws them.
#pragma once

#include <filesystem>
#include <vector>

#include "probes/sectors/level_light.h"
#include "render/probe_sphere.h"

namespace welkin::render {

class LevelProbes {
 public:
  /// Reads the level's sky and [scale], and every sector_X_Z.welkin in DIR/sectors, in the order of the sectors. Throws
  /// Error: `file` where the folder or a file cannot be read, or where there is no sector; `content` for a sector that
  /// is damaged or another than its name says.
  LevelProbes(const std::filesystem::path& level, const std::filesystem::path& folder);

  /// At a finite time in hours: sky, bounced sun and moon, and emission, with the level's [scale].
  std::vector<ProbeSphere> at(double time_h) const;

 private:
  model::Sky sky_;
  transfer::RelightScale scale_;
  std::vector<sectors::SectorFile> sectors_;
};

}  // namespace welkin::render
