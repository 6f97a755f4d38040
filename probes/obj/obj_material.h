// SPDX-License-Identifier: Apache-2.0
// Reads the materials of an OBJ file into a scene.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "probes/level/scene_builder.h"
#include "probes/obj/mtl_file.h"

namespace welkin::obj {

class ObjMaterials {
 public:
  /// Reads the material files that the OBJ file names, one or several a line; a missing one is a warning. The first of
  /// two materials with one name counts. `builder` must outlive the object. Throws Error.
  ObjMaterials(const std::filesystem::path& obj, const std::vector<std::string>& libraries,
               level::SceneBuilder& builder);

  /// Index into Scene::materials; nothing if level.toml's albedo takes its place. Without `has_uv` the material's image
  /// has no effect.
  std::optional<uint32_t> at(const std::string& name, bool has_uv);

  /// Warns once about images and materials that at() found missing, and images in a format that is not read.
  void warn();

 private:
  struct Source {
    MtlMaterial material;
    std::filesystem::path folder;
  };
  void readLibrary(const std::filesystem::path& path);
  const Source* find(const std::string& name) const;
  std::optional<uint32_t> read(const Source& source, bool has_uv);
  /// Whether it emits.
  bool readEmission(const Source& source, bool has_uv, geometry::Material& surface);
  void readAlpha(const MtlMaterial& material, geometry::Material& surface);
  std::optional<int> readTexture(const MtlMap& map, const std::filesystem::path& folder);

  std::string obj_;
  level::SceneBuilder& builder_;
  std::map<std::string, Source> sources_;
  std::map<std::string, const Source*> commented_;  // by the name up to its first # after space
  std::map<std::pair<std::string, bool>, std::optional<uint32_t>> read_;
  std::vector<std::string> missing_images_;
  std::vector<std::string> foreign_images_;
  std::vector<std::string> unknown_materials_;
};

}  // namespace welkin::obj
