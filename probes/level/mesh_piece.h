// SPDX-License-Identifier: Apache-2.0
// A piece of a mesh: triangles of one material, appended to the scene whatever kind of file they come from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "probes/level/scene.h"

namespace welkin::level {

/// Floats, `components` an element; no components: there are none.
struct FloatRows {
  std::size_t count = 0;
  int components = 0;
  std::vector<float> values;
};

/// What the vertices of a piece have; all that have any have as many.
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
  std::optional<uint32_t> material;  ///< of Scene::materials; none: level.toml's albedo, or the vertex colours alone
  bool coloured = false;
  std::size_t dropped_triangles = 0;  ///< without area or not finite
  Bounds bounds;                      ///< in the mesh's axes
};

/// Appends the triangles, three of `indices` each and all below the vertices' count, with the vertices that they use.
/// Without normals every triangle is flat. Throws Error(content), beginning with `what`, where a scene can hold no
/// more.
MeshPiece appendPiece(Scene& scene, const Attributes& attributes, const std::vector<uint32_t>& indices,
                      const std::string& what);

}  // namespace welkin::level
