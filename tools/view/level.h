// SPDX-License-Identifier: Apache-2.0
// A baked level with the files that it was baked from: everything in the viewer that does not change with time or
// camera.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "baked/level_folder.h"
#include "probes/build/subject.h"
#include "probes/geometry/tracer.h"
#include "probes/level/scene.h"
#include "probes/sectors/level_light.h"
#include "view/state.h"

namespace welkin::view {

struct LevelFiles {
  std::filesystem::path folder;  ///< of the bake
  std::filesystem::path level;   ///< level.toml
  std::string warning;           ///< where that is not the file that was baked
};

/// The files of a command line, as baked::levelSource finds them. Throws Error(file).
LevelFiles levelFiles(const std::filesystem::path& folder, const std::filesystem::path& level);

struct SectorCost {
  geometry::SectorId id;
  std::size_t probes = 0;
  std::size_t bytes = 0;  ///< of the file
};

/// A complaint, and where it is.
struct Warning {
  std::string id, message;
  std::optional<f64::Number3> place;  ///< of the level as a whole: none
};

class Level {
 public:
  /// Throws Error.
  explicit Level(const LevelFiles& files);

  const LevelFiles& files() const { return files_; }
  baked::LevelFolder& baked() { return *baked_; }
  const Sky& sky() const { return baked_->sky(); }
  const build::Subject& subject() const { return subject_; }
  const level::Scene& scene() const { return scene_; }
  const geometry::Tracer& tracer() const { return *tracer_; }
  const std::vector<sectors::SectorFile>& sectors() const { return sectors_; }
  /// Null if the level has no such sector.
  const sectors::SectorFile* sector(geometry::SectorId id) const;
  const std::vector<SectorCost>& costs() const { return costs_; }
  const std::vector<Warning>& warnings() const { return warnings_; }
  /// Reads the folder anew, as another bake has left it, with its contact factors if they are of that bake; with
  /// sectors' files in place of the folder's, by their sectors, which a bake that is not done has made. What has
  /// pointed into baked() must be gone. Throws Error; then the level is as before.
  void reload(const std::map<geometry::SectorId, std::vector<std::byte>>& instead = {});
  /// The place of a probe; the name must exist.
  f64::Number3 placeOf(const ProbeName& name) const;

 private:
  LevelFiles files_;
  std::unique_ptr<baked::LevelFolder> baked_;
  build::Subject subject_;
  level::Scene scene_;
  std::unique_ptr<geometry::Tracer> tracer_;
  std::vector<sectors::SectorFile> sectors_;  ///< ascending
  std::vector<SectorCost> costs_;
  std::vector<Warning> warnings_;
};

}  // namespace welkin::view
