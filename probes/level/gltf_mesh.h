// SPDX-License-Identifier: Apache-2.0
// The meshes of a glTF model, each read into the scene when it is first placed.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "probes/level/gltf_material.h"
#include "probes/level/mesh_piece.h"

namespace welkin::probes {

class GltfMeshes {
 public:
  /// All arguments outlive the object.
  GltfMeshes(const tinygltf::Model& model, const AccessorReader& reader, SceneBuilder& builder)
      : model_(model), reader_(reader), scene_(builder.scene()), materials_(model, reader, builder) {}

  /// The pieces of mesh `index` of the model, which is one of its meshes; they stay where they are. Throws as
  /// GltfMaterials does.
  const std::vector<MeshPiece>& pieces(int index);

 private:
  MeshPiece readPrimitive(const tinygltf::Primitive& primitive, const std::string& what);
  Attributes readAttributes(const tinygltf::Primitive& primitive, int uv_set, const std::string& what) const;

  const tinygltf::Model& model_;
  const AccessorReader& reader_;
  Scene& scene_;
  GltfMaterials materials_;
  std::map<int, std::vector<MeshPiece>> meshes_;
};

}  // namespace welkin::probes
