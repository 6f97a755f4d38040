// SPDX-License-Identifier: Apache-2.0
#include "render/level_probes.h"

#include <map>
#include <optional>
#include <string>

#include "probes/build/bake_section.h"
#include "probes/geometry/sector_name.h"
#include "probes/level/level_file.h"
#include "sky/bake/sky_file.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"

namespace welkin::render {
namespace {

namespace fs = std::filesystem;
using geometry::SectorId;
using sectors::SectorFile;

/// Returns the sector in a file of this name. Nothing for a name that a bake does not use.
std::optional<SectorId> sectorOf(const std::string& name) {
  const std::string head = "sector_";
  const std::string tail = ".welkin";
  if (!name.starts_with(head) || !name.ends_with(tail) || name.size() < head.size() + tail.size()) return std::nullopt;
  return geometry::sectorOf(name.substr(head.size(), name.size() - head.size() - tail.size()));
}

std::map<SectorId, fs::path> sectorPaths(const fs::path& folder) {
  std::map<SectorId, fs::path> paths;
  std::error_code error;
  for (fs::directory_iterator i(folder, error); !error && i != fs::directory_iterator(); i.increment(error))
    if (const auto id = sectorOf(i->path().filename().string())) paths.emplace(*id, i->path());
  if (error) throw base::Error(base::ExitStatus::file, "--probes: " + folder.string() + ": " + error.message());
  if (paths.empty())
    throw base::Error(base::ExitStatus::file,
                      "--probes: " + folder.string() + ": holds no sector; bake the level into its folder");
  return paths;
}

}  // namespace

LevelProbes::LevelProbes(const base::TomlFile& level, const fs::path& folder)
    : sky_(bake::readSkyFile(level::levelFileOf(level).sky).sky), scale_(build::bakeSectionOf(level).scale) {
  constexpr std::size_t kLargestSector = std::size_t{16} << 20;
  for (const auto& [id, path] : sectorPaths(folder / "sectors")) {
    sectors_.push_back(sectors::decodeSector(base::readFile(path, kLargestSector), path.string()));
    if (sectors_.back().id != id)
      throw base::Error(base::ExitStatus::content, path.string() + ": holds the sector " + nameOf(sectors_.back().id));
  }
}

std::vector<ProbeSphere> LevelProbes::at(double time_h) const {
  const sectors::LevelLight light(sectors_, sky_, time_h, scale_);
  std::vector<ProbeSphere> spheres;
  for (const SectorFile& sector : sectors_) {
    const std::vector<f64::Number3> position = transfer::decodedProbes(sector.probes, sector.id).position;
    const std::vector<transfer::ProbeIrradiance>& irradiance = light.probesOf(sector.id);
    for (std::size_t i = 0; i < position.size(); ++i) {
      const auto total = irradiance[i].total();
      ProbeSphere sphere{};
      for (int c = 0; c < 3; ++c) {
        sphere.position[c] = static_cast<float>(position[i][c]);
        for (std::size_t b = 0; b < total.size(); ++b) sphere.irradiance[b][c] = static_cast<float>(total[b][c]);
      }
      spheres.push_back(sphere);
    }
  }
  return spheres;
}

}  // namespace welkin::render
