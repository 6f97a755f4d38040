// SPDX-License-Identifier: Apache-2.0
#include "probes/build/subject.h"

#include <fmt/format.h>

#include <iterator>

#include "probes/loader/read_scene.h"
#include "probes/loader/surfaces_of.h"
#include "sky/bake/family.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"

namespace welkin::build {
namespace {

bake::Input hashed(const std::filesystem::path& path) {
  return bake::inputOf(path.filename().string(), path, base::readFile(path));
}

/// The loader opens files on its own. One that has changed since it was hashed may have been read as another.
void requireUnchanged(const bake::Input& input) {
  const bake::Input now = hashed(input.path);
  if (now.xxh3_low != input.xxh3_low || now.xxh3_high != input.xxh3_high)
    throw base::Error(base::ExitStatus::file, input.path.string() + ": changed while it was read; bake again");
}

/// Unless the file asks for some.
void leaveOutCubemaps(bake::BakeSettings& bake) {
  if (bake.fixed.cubemaps || bake.cubemap_error) return;
  bake.cubemap_time_h.clear();
  bake.fixed.cubemaps = true;
}

/// Takes the first sky, and reads further ones of its family. The first `named` keep their names, the others have those
/// of their files.
void readSkies(bake::SkyFile first, const std::vector<std::filesystem::path>& more, std::size_t named,
               Subject& subject) {
  std::vector<bake::SkyFile> family = {std::move(first)};
  for (const std::filesystem::path& path : more) family.push_back(bake::readSkyFile(path));
  if (!more.empty()) bake::nameAfterFiles(family, named);
  for (const bake::SkyFile& sky : family)
    subject.inputs.insert(subject.inputs.end(), sky.inputs.begin(), sky.inputs.end());
  subject.sky = std::move(family.front());
  subject.more.assign(std::make_move_iterator(family.begin() + 1), std::make_move_iterator(family.end()));
}

Subject subjectOf(const base::TomlFile& toml) {
  const level::LevelFile file = level::levelFileOf(toml);
  Level level{bakeSectionOf(toml), {}};
  Subject subject;
  readSkies({bake::readSkyFile(file.sky)}, file.more_skies, 1, subject);
  subject.inputs.push_back(bake::inputOf(toml.path.filename().string(), toml.path, toml.bytes));
  const std::size_t first = subject.inputs.size();
  for (const level::GeometryEntry& geometry : file.geometry) subject.inputs.push_back(hashed(geometry.path));
  level::Scene scene = loader::readScene(file);
  std::vector<std::filesystem::path> files = scene.files;
  for (const bake::Input& input : subject.inputs) files.push_back(input.path);
  if (file.outside_files == level::OutsideFiles::refuse) level::requireInside(file.folder, files);
  if (const auto outside = level::filesOutside(file.folder, files);
      file.outside_files == level::OutsideFiles::warn && !outside.empty())
    scene.warnings.push_back("reads files " + level::outsideText(outside) +
                             "; [level] outside_files = \"refuse\" or \"allow\"");
  for (std::size_t i = first; i < subject.inputs.size(); ++i) requireUnchanged(subject.inputs[i]);
  if (scene.least_roughness > kReflectiveRoughness) {
    leaveOutCubemaps(subject.sky.bake);
    for (bake::SkyFile& sky : subject.more) leaveOutCubemaps(sky.bake);
  }
  try {
    level.surfaces = loader::surfacesOf(scene, subject.sky.sky.luminance_unit);
  } catch (const base::Error& e) {
    if (file.outside_files == level::OutsideFiles::allow) throw;
    level::throwWithoutBytes(e, toml.path, file.folder, files);
  }
  subject.level = std::move(level);
  return subject;
}

}  // namespace

Subject readSubject(const std::filesystem::path& path, const std::vector<std::filesystem::path>& more) {
  const base::TomlFile toml = base::readToml(path);
  if (toml.root.contains("level") && !toml.root.contains("sky")) {
    if (more.empty()) return subjectOf(toml);
    throw base::Error(base::ExitStatus::usage,
                      fmt::format("{}: is a level file and stands beside {}; only sky files are baked together: list a "
                                  "level's in its sky = [..]",
                                  path.string(), more.front().string()));
  }
  Subject subject;
  readSkies(bake::skyFileOf(toml), more, 0, subject);
  return subject;
}

Subject readLevel(const std::filesystem::path& path) {
  return subjectOf(base::readToml(path));
}

}  // namespace welkin::build
