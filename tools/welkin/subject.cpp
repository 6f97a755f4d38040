// SPDX-License-Identifier: Apache-2.0
#include "welkin/subject.h"

#include "probes/level/scene.h"
#include "sky/atomic_file.h"
#include "sky/toml_table.h"

namespace welkin::tools {
namespace {

bool isLevel(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  const toml::table root = sky::parseToml(path.string(), {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  return root.contains("level") && !root.contains("sky");
}

}  // namespace

std::vector<sky::Input> Subject::inputs() const {
  std::vector<sky::Input> inputs = sky.inputs;
  inputs.insert(inputs.end(), level_inputs.begin(), level_inputs.end());
  return inputs;
}

Subject readSubject(const std::filesystem::path& path) {
  constexpr std::size_t kLargestFile = std::size_t{16} << 20;
  const auto bytes = readFile(path, kLargestFile);
  if (!isLevel(path, bytes)) return {sky::readSkyFile(path)};
  const probes::LevelFile level = probes::readLevelFile(path);
  Subject subject{sky::readSkyFile(level.sky)};
  subject.level = path;
  subject.level_inputs.push_back(sky::inputOf(path.filename().string(), path, bytes));
  for (const probes::GeometryEntry& geometry : level.geometry)
    subject.level_inputs.push_back(
        sky::inputOf(geometry.path.filename().string(), geometry.path, readFile(geometry.path)));
  subject.nothing_reflects = probes::readScene(level).least_roughness > kReflectiveRoughness;
  sky::BakeSettings& bake = subject.sky.bake;
  if (subject.nothing_reflects && !bake.fixed.cubemaps) {
    bake.cubemap_time_h.clear();
    bake.fixed.cubemaps = true;
  }
  return subject;
}

}  // namespace welkin::tools
