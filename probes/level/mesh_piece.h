// SPDX-License-Identifier: Apache-2.0
// A piece of a mesh: triangles of one material, appended to the scene for any kind of file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "probes/level/scene.h"

namespace welkin::level {

/// Rows of `components` floats. 0 components mean that the attribute is missing.
struct FloatRows {
  std::size_t count = 0;
  int components = 0;
  std::vector<float> values;
};

/// Attributes of a piece's vertices. All attributes that are there have the same count.
struct Attributes {
  FloatRows positions;  ///< 3
  FloatRows normals;    ///< 3
  FloatRows colours;    ///< 3 or 4, linear; the fourth is left out
  FloatRows uv;         ///< 2
};

struct MeshPiece {
  uint32_t first_index = 0;
  uint32_t index_count = 0;
  int32_t vertex_offset = 0;
  std::optional<uint32_t> material;  ///< in Scene::materials; none: level.toml's albedo, or vertex colours alone
  bool coloured = false;
  std::size_t dropped_triangles = 0;  ///< triangles without area or with numbers that are not finite
  Bounds bounds;                      ///< in the mesh's axes
};

/// Appends the triangles and the vertices that they use. Each triangle takes three `indices`, all below the number of
/// vertices. Without normals every triangle is flat. Throws Error(content), beginning with `what`, if the scene is
/// full.
MeshPiece appendPiece(Scene& scene, const Attributes& attributes, const std::vector<uint32_t>& indices,
                      const std::string& what);

}  // namespace welkin::level
