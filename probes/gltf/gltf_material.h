// SPDX-License-Identifier: Apache-2.0
// Reads the materials of a glTF model into the scene, each when it is first used. glTF 2.0, 3.9.
#pragma once

#include <map>
#include <string>

#include "probes/gltf/accessor.h"
#include "probes/level/scene_builder.h"

namespace welkin::gltf {

struct GltfMaterial {
  uint32_t material = 0;  ///< index into Scene::materials
  int uv_set = -1;        ///< n of the TEXCOORD_n for the textures; -1: no texture
};

/// Materials are opaque, masked or blended, as the file says, and may pass light (KHR_materials_transmission).
class GltfMaterials {
 public:
  /// All arguments must outlive the object.
  GltfMaterials(const tinygltf::Model& model, const AccessorReader& reader, level::SceneBuilder& builder)
      : model_(model), reader_(reader), builder_(builder) {}

  /// Material `index`; `what` names its user in messages. Throws Error: `file` if an image's file cannot be read, else
  /// `content`.
  const GltfMaterial& at(int index, const std::string& what);

  /// A material that at() has read, with its base colour's factor alone.
  GltfMaterial withoutTexture(int index);

 private:
  GltfMaterial read(const tinygltf::Material& material, const std::string& name);
  /// A texture, and the coordinates that it takes.
  struct Use {
    int texture = -1;
    int uv_set = 0;
    geometry::UvRows uv_row = geometry::kSameUv;
  };
  Use readUse(int index, int uv_set, const tinygltf::Value& transform, const std::string& what);
  void readMetal(const tinygltf::Material& material, level::SceneMaterial& into);
  /// Index into Scene::metal_textures of a texture's plain source; -1 if its format is not read.
  int readMetalTexture(int index);
  void readAlpha(const tinygltf::Material& material, const std::string& name, geometry::Material& surface);
  void readTransmission(const tinygltf::Material& material, const std::string& name, level::SceneMaterial& into);
  void readEmission(const tinygltf::Material& material, const std::string& name, int& uv_set,
                    level::SceneMaterial& into);
  /// Index of a texture in the scene, of the first of its images whose format is read: WebP, DDS, its plain source. -1,
  /// with a warning, if there is none.
  int readTexture(int index, const std::string& what);
  level::TextureSource readImage(int index, const std::string& what);

  const tinygltf::Model& model_;
  const AccessorReader& reader_;
  level::SceneBuilder& builder_;
  std::map<int, GltfMaterial> materials_;
  std::map<int, GltfMaterial> without_texture_;
  std::map<int, int> metal_textures_;  ///< by image
};

}  // namespace welkin::gltf
