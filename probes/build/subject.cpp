// SPDX-License-Identifier: Apache-2.0
#include "probes/build/subject.h"

#include "probes/loader/read_scene.h"
#include "sky/base/atomic_file.h"
#include "sky/base/toml_table.h"

namespace welkin::build {
namespace {

bool isLevel(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  const toml::table root = base::parseToml(path.string(), {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  return root.contains("level") && !root.contains("sky");
}

}  // namespace

std::vector<bake::Input> Subject::inputs() const {
  std::vector<bake::Input> inputs = sky.inputs;
  inputs.insert(inputs.end(), level_inputs.begin(), level_inputs.end());
  return inputs;
}

Subject readSubject(const std::filesystem::path& path) {
  constexpr std::size_t kLargestFile = std::size_t{16} << 20;
  const auto bytes = base::readFile(path, kLargestFile);
  if (!isLevel(path, bytes)) return {bake::readSkyFile(path)};
  const level::LevelFile level = level::readLevelFile(path);
  Subject subject{bake::readSkyFile(level.sky)};
  subject.level = path;
  subject.level_inputs.push_back(bake::inputOf(path.filename().string(), path, bytes));
  for (const level::GeometryEntry& geometry : level.geometry)
    subject.level_inputs.push_back(
        bake::inputOf(geometry.path.filename().string(), geometry.path, base::readFile(geometry.path)));
  subject.nothing_reflects = loader::readScene(level).least_roughness > kReflectiveRoughness;
  bake::BakeSettings& bake = subject.sky.bake;
  if (subject.nothing_reflects && !bake.fixed.cubemaps) {
    bake.cubemap_time_h.clear();
    bake.fixed.cubemaps = true;
  }
  return subject;
}

}  // namespace welkin::build
