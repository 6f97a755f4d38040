// SPDX-License-Identifier: Apache-2.0
#include "probes/loader/read_scene.h"

#include <fmt/format.h>

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

/// The refusal, with the likeliest reason: triangles that are dropped, or a file that is no OBJ and so has none of its
/// words.
base::Error nothingToDraw(const level::LevelFile& level, const level::Scene& scene) {
  std::size_t dropped = 0;
  for (const level::Draw& draw : scene.draws) dropped += draw.dropped_triangles * draw.instance_count;
  std::string why;
  if (dropped > 0)
    why = fmt::format("; its {} triangles are without area, or not finite", dropped);
  else if (!scene.warnings.empty() && scene.warnings.front().find(": not read: ") != std::string::npos)
    why = "; " + scene.warnings.front();
  return {base::ExitStatus::content,
          fmt::format("{}: the level holds nothing to draw{}", level.geometry.front().path.string(), why)};
}

}  // namespace

level::Scene readScene(const level::LevelFile& level) {
  level::SceneBuilder builder;
  std::map<std::filesystem::path, std::unique_ptr<level::GeometrySource>> sources;
  const level::OutsideFiles rule = level.outside_files;
  for (const level::GeometryEntry& entry : level.geometry) {
    try {
      auto& source = sources[entry.path.lexically_normal()];
      const std::size_t warned = builder.scene().warnings.size();
      if (!source) source = readSource(entry.path, builder);
      if (rule == level::OutsideFiles::refuse) level::requireInside(level.folder, builder.scene().files);
      if (rule == level::OutsideFiles::warn)
        level::leaveOutWords(level.folder, builder.scene().files, builder.scene().warnings, warned);
      source->place(entry);
    } catch (const base::Error& e) {
      if (rule == level::OutsideFiles::allow) throw;
      level::throwWithoutBytes(e, entry.path, level.folder, builder.scene().files);
    }
  }
  level::Scene scene = builder.finish();
  if (scene.indices.empty() || scene.draws.empty()) throw nothingToDraw(level, scene);
  return scene;
}

}  // namespace welkin::loader
