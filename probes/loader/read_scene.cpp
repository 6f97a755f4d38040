// SPDX-License-Identifier: Apache-2.0
#include "probes/loader/read_scene.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "probes/gltf/gltf_scene.h"
#include "probes/obj/obj_scene.h"
#include "sky/base/error.h"

namespace welkin::loader {
namespace {

std::unique_ptr<level::GeometrySource> readSource(const std::filesystem::path& path, level::SceneBuilder& builder) {
  std::string suffix = path.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (suffix == ".gltf" || suffix == ".glb") return gltf::readGltfSource(path, builder);
  if (suffix == ".obj") return obj::readObjSource(path, builder);
  throw base::Error(base::ExitStatus::content,
                    path.string() + ": levels are made of glTF 2.0 (.gltf, .glb) and OBJ (.obj)");
}

}  // namespace

level::Scene readScene(const level::LevelFile& level) {
  level::SceneBuilder builder;
  std::map<std::filesystem::path, std::unique_ptr<level::GeometrySource>> sources;
  const level::OutsideFiles rule = level.outside_files;
  for (const level::GeometryEntry& entry : level.geometry) {
    try {
      auto& source = sources[entry.path.lexically_normal()];
      if (!source) source = readSource(entry.path, builder);
      if (rule == level::OutsideFiles::refuse) level::requireInside(level.folder, builder.scene().files);
      source->place(entry);
    } catch (const base::Error& e) {
      if (rule == level::OutsideFiles::allow) throw;
      level::throwWithoutBytes(e, entry.path, level.folder, builder.scene().files);
    }
  }
  level::Scene scene = builder.finish();
  if (scene.indices.empty() || scene.draws.empty())
    throw base::Error(base::ExitStatus::content,
                      level.geometry.front().path.string() + ": the level holds nothing to draw");
  return scene;
}

}  // namespace welkin::loader
