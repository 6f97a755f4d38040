// SPDX-License-Identifier: Apache-2.0
// The materials of a glTF model, each read into the scene when it is first used. glTF 2.0, 3.9.
#pragma once

#include <map>
#include <string>

#include "probes/level/scene_builder.h"
#include "probes/loader/accessor.h"

namespace welkin::loader {

struct GltfMaterial {
  uint32_t material = 0;  ///< of Scene::materials
  int uv_set = -1;        ///< the TEXCOORD_n that the base colour's texture asks for; -1: it has none
};

/// Opaque, masked as the file says, and blended as if masked at an alpha of 1/2, which is reported.
class GltfMaterials {
 public:
  /// All arguments outlive the object.
  GltfMaterials(const tinygltf::Model& model, const AccessorReader& reader, level::SceneBuilder& builder)
      : model_(model), reader_(reader), builder_(builder) {}

  /// Material `index`, which `what` asks for. Throws Error: `file` for an image's file that cannot be read, else
  /// `content`.
  const GltfMaterial& at(int index, const std::string& what);

 private:
  GltfMaterial read(const tinygltf::Material& material, const std::string& name);
  void readAlpha(const tinygltf::Material& material, const std::string& name, geometry::Material& surface);
  void readEmission(const tinygltf::Material& material, const std::string& name, level::SceneMaterial& into);
  int readTexture(int index, const std::string& what);
  level::TextureSource readImage(int index, const std::string& what);

  const tinygltf::Model& model_;
  const AccessorReader& reader_;
  level::SceneBuilder& builder_;
  std::map<int, GltfMaterial> materials_;
};

}  // namespace welkin::loader
