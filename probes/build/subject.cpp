// SPDX-License-Identifier: Apache-2.0
#include "probes/build/subject.h"

#include "probes/loader/read_scene.h"
#include "probes/loader/surfaces_of.h"
#include "sky/base/atomic_file.h"

namespace welkin::build {
namespace {

Subject subjectOf(const base::TomlFile& toml) {
  const level::LevelFile file = level::levelFileOf(toml);
  Level level{bakeSectionOf(toml), {}};
  Subject subject{bake::readSkyFile(file.sky), {}, {}};
  subject.inputs = subject.sky.inputs;
  subject.inputs.push_back(bake::inputOf(toml.path.filename().string(), toml.path, toml.bytes));
  for (const level::GeometryEntry& geometry : file.geometry)
    subject.inputs.push_back(
        bake::inputOf(geometry.path.filename().string(), geometry.path, base::readFile(geometry.path)));
  const level::Scene scene = loader::readScene(file);
  bake::BakeSettings& bake = subject.sky.bake;
  if (scene.least_roughness > kReflectiveRoughness && !bake.fixed.cubemaps) {
    bake.cubemap_time_h.clear();
    bake.fixed.cubemaps = true;
  }
  level.surfaces = loader::surfacesOf(scene, subject.sky.sky.luminance_unit);
  subject.level = std::move(level);
  return subject;
}

}  // namespace

Subject readSubject(const std::filesystem::path& path) {
  const base::TomlFile toml = base::readToml(path);
  if (toml.root.contains("level") && !toml.root.contains("sky")) return subjectOf(toml);
  Subject subject{bake::skyFileOf(toml), {}, {}};
  subject.inputs = subject.sky.inputs;
  return subject;
}

Subject readLevel(const std::filesystem::path& path) {
  return subjectOf(base::readToml(path));
}

}  // namespace welkin::build
