// SPDX-License-Identifier: Apache-2.0
// Reads the meshes of a glTF model into the scene, each when it is first placed.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "probes/gltf/gltf_material.h"
#include "probes/level/mesh_piece.h"

namespace welkin::gltf {

class GltfMeshes {
 public:
  /// All arguments must outlive the object.
  GltfMeshes(const tinygltf::Model& model, const AccessorReader& reader, level::SceneBuilder& builder)
      : model_(model), reader_(reader), scene_(builder.scene()), materials_(model, reader, builder) {}

  /// The pieces of mesh `index`, which must exist in the model, with its morph targets by `weights`; the mesh's own
  /// weights if these are empty. The reference stays valid. Throws as GltfMaterials does.
  const std::vector<level::MeshPiece>& pieces(int index, const std::vector<double>& weights);

 private:
  level::MeshPiece readPrimitive(const tinygltf::Primitive& primitive, const std::vector<double>& weights,
                                 const std::string& what);
  level::Attributes readAttributes(const tinygltf::Primitive& primitive, int uv_set, const std::string& what) const;
  /// The primitive's material; without its texture, and with a warning, if the primitive lacks the coordinates.
  GltfMaterial materialOf(const tinygltf::Primitive& primitive, const std::string& what);

  const tinygltf::Model& model_;
  const AccessorReader& reader_;
  level::Scene& scene_;
  GltfMaterials materials_;
  std::map<std::pair<int, std::vector<double>>, std::vector<level::MeshPiece>> meshes_;
};

}  // namespace welkin::gltf
