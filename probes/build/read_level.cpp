// SPDX-License-Identifier: Apache-2.0
#include "probes/build/read_level.h"

#include "probes/loader/surfaces_of.h"

namespace welkin::build {

void addLevelWarnings(const LevelInput& level, nlohmann::ordered_json& warnings) {
  for (const std::string& warning : level.warnings) warnings.push_back({{"id", "geometry"}, {"message", warning}});
  if (level.bake.sectors().empty())
    warnings.push_back({{"id", "no-sectors"},
                        {"message",
                         "the level has no sector: no static surface faces up, nothing is vegetation, and no probe is "
                         "added by hand"}});
}

LevelInput readLevel(const std::filesystem::path& path, const model::Sky& sky, std::optional<double> max_error,
                     const base::Progress& progress) {
  const level::LevelFile file = level::readLevelFile(path);
  const BakeSection section = readBakeSection(path);
  geometry::Surfaces surfaces = loader::readSurfaces(file);
  std::vector<std::filesystem::path> files = surfaces.file;
  std::vector<std::string> warnings = surfaces.warning;
  return {LevelBake(std::move(surfaces), section, sky, max_error, progress), std::move(files), std::move(warnings)};
}

}  // namespace welkin::build
