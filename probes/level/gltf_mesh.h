// SPDX-License-Identifier: Apache-2.0
// The meshes of a glTF model, each read into the scene when it is first placed.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "probes/level/accessor.h"
#include "probes/level/scene.h"

namespace welkin::probes {

/// One primitive of a mesh, its triangles in the scene.
struct GltfPiece {
  uint32_t first_index = 0;
  uint32_t index_count = 0;
  int32_t vertex_offset = 0;
  f64::Number3 albedo;  ///< times the vertex colours
  bool double_sided = false;
  double roughness = 1.0;  ///< 0: a mirror
  Bounds bounds;           ///< in the mesh's axes
};

class GltfMeshes {
 public:
  /// `albedo` is that of a primitive with neither a material nor colours. All arguments outlive the object.
  GltfMeshes(const tinygltf::Model& model, const AccessorReader& reader, const f64::Number3& albedo, Scene& scene)
      : model_(model), reader_(reader), albedo_(albedo), scene_(scene) {}

  /// The pieces of mesh `index` of the model, which is one of its meshes; they stay where they are. Throws
  /// Error(content).
  const std::vector<GltfPiece>& pieces(int index);

 private:
  GltfPiece readPrimitive(const tinygltf::Primitive& primitive, const std::string& what);
  void readMaterial(const tinygltf::Primitive& primitive, const std::string& what, bool coloured,
                    GltfPiece& piece) const;
  void append(const FloatRows& positions, const FloatRows& normals, const FloatRows& colours,
              const std::vector<uint32_t>& indices, const std::string& what, GltfPiece& piece);

  const tinygltf::Model& model_;
  const AccessorReader& reader_;
  const f64::Number3& albedo_;
  Scene& scene_;
  std::map<int, std::vector<GltfPiece>> meshes_;
};

}  // namespace welkin::probes
