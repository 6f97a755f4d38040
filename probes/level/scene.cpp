// SPDX-License-Identifier: Apache-2.0
// Reads a level's geometry, file by file.
#include "probes/level/scene.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "probes/level/gltf_scene.h"
#include "probes/level/obj_scene.h"
#include "sky/error.h"

namespace welkin::probes {
namespace {

std::unique_ptr<GeometrySource> readSource(const std::filesystem::path& path, SceneBuilder& builder) {
  std::string suffix = path.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (suffix == ".gltf" || suffix == ".glb") return readGltfSource(path, builder);
  if (suffix == ".obj") return readObjSource(path, builder);
  throw Error(ExitStatus::content, path.string() + ": levels are made of glTF 2.0 (.gltf, .glb) and OBJ (.obj)");
}

}  // namespace

void Bounds::add(const f64::Number3& p) {
  for (int i = 0; i < 3; ++i) {
    low[i] = std::min(low[i], p[i]);
    high[i] = std::max(high[i], p[i]);
  }
}

Scene readScene(const LevelFile& level) {
  SceneBuilder builder;
  std::map<std::filesystem::path, std::unique_ptr<GeometrySource>> sources;
  for (const GeometryEntry& entry : level.geometry) {
    auto& source = sources[entry.path.lexically_normal()];
    if (!source) source = readSource(entry.path, builder);
    source->place(entry);
  }
  Scene scene = builder.finish();
  if (scene.indices.empty() || scene.draws.empty())
    throw Error(ExitStatus::content, level.geometry.front().path.string() + ": the level holds nothing to draw");
  return scene;
}

}  // namespace welkin::probes
