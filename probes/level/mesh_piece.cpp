// SPDX-License-Identifier: Apache-2.0
#include "probes/level/mesh_piece.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sky/base/error.h"

namespace welkin::level {
namespace {

using f64::Number3;
using Corners = std::array<uint32_t, 3>;

Number3 position(const Vertex& v) {
  return {double{v.position[0]}, double{v.position[1]}, double{v.position[2]}};
}

/// A vector along the normal, twice as long as the triangle's area.
Number3 areaVector(const Vertex& a, const Vertex& b, const Vertex& c) {
  return cross(position(b) - position(a), position(c) - position(a));
}

bool isFinite(const FloatRows& rows, std::size_t i) {
  const auto n = static_cast<std::size_t>(rows.components);
  return std::all_of(rows.values.begin() + static_cast<std::ptrdiff_t>(n * i),
                     rows.values.begin() + static_cast<std::ptrdiff_t>(n * (i + 1)),
                     [](float v) { return std::isfinite(v); });
}

void copy(const FloatRows& rows, std::size_t i, int count, float* to) {
  if (rows.components == 0) return;
  std::copy_n(rows.values.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(rows.components) * i), count,
              to);
}

Vertex vertexOf(const Attributes& from, std::size_t i) {
  Vertex vertex{{}, {0.0F, 1.0F, 0.0F}, {1.0F, 1.0F, 1.0F}, {}};
  copy(from.positions, i, 3, vertex.position);
  copy(from.normals, i, 3, vertex.normal);
  copy(from.colours, i, 3, vertex.colour);
  copy(from.uv, i, 2, vertex.uv);
  return vertex;
}

/// The triangles that have an area and only finite numbers.
std::vector<Corners> usableTriangles(const Attributes& attributes, const std::vector<uint32_t>& indices) {
  std::vector<Corners> usable;
  usable.reserve(indices.size() / 3);
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const Corners t{indices[i], indices[i + 1], indices[i + 2]};
    const bool finite = std::all_of(t.begin(), t.end(), [&](uint32_t v) {
      return isFinite(attributes.positions, v) && isFinite(attributes.normals, v) && isFinite(attributes.colours, v) &&
             isFinite(attributes.uv, v);
    });
    if (!finite) continue;
    const Number3 area = areaVector(vertexOf(attributes, t[0]), vertexOf(attributes, t[1]), vertexOf(attributes, t[2]));
    if (dot(area, area) > 0.0) usable.push_back(t);
  }
  return usable;
}

/// Appends every triangle with three vertices of its own and its plane's normal (glTF 2.0, 3.7.2.1).
void appendFlat(Scene& scene, const Attributes& attributes, const std::vector<Corners>& triangles, MeshPiece& piece) {
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    std::array<Vertex, 3> corner{};
    for (std::size_t c = 0; c < 3; ++c) corner[c] = vertexOf(attributes, triangles[i][c]);
    const Number3 area = areaVector(corner[0], corner[1], corner[2]);
    const Number3 normal = area / std::sqrt(dot(area, area));
    for (std::size_t c = 0; c < 3; ++c) {
      for (int axis = 0; axis < 3; ++axis) corner[c].normal[axis] = static_cast<float>(normal[axis]);
      piece.bounds.add(position(corner[c]));
      scene.vertices.push_back(corner[c]);
      scene.indices.push_back(static_cast<uint32_t>(3 * i + c));
    }
  }
}

void appendSmooth(Scene& scene, const Attributes& attributes, const std::vector<Corners>& triangles, MeshPiece& piece) {
  constexpr uint32_t kUnused = std::numeric_limits<uint32_t>::max();
  std::vector<uint32_t> place(attributes.positions.count, kUnused);
  for (const Corners& t : triangles)
    for (const uint32_t v : t) place[v] = 0;
  uint32_t used = 0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (place[i] == kUnused) continue;
    place[i] = used++;
    scene.vertices.push_back(vertexOf(attributes, i));
    piece.bounds.add(position(scene.vertices.back()));
  }
  for (const Corners& t : triangles)
    for (const uint32_t v : t) scene.indices.push_back(place[v]);
}

}  // namespace

MeshPiece appendPiece(Scene& scene, const Attributes& attributes, const std::vector<uint32_t>& indices,
                      const std::string& what) {
  const std::vector<Corners> triangles = usableTriangles(attributes, indices);
  const bool flat = attributes.normals.components == 0;
  const std::size_t added = flat ? 3 * triangles.size() : attributes.positions.count;
  constexpr std::size_t kMost = std::numeric_limits<int32_t>::max();
  if (scene.vertices.size() + added > kMost || scene.indices.size() + 3 * triangles.size() > kMost)
    throw base::Error(base::ExitStatus::content, what + ": the level has more than 2^31 vertices or indices");
  MeshPiece piece;
  piece.first_index = static_cast<uint32_t>(scene.indices.size());
  piece.index_count = static_cast<uint32_t>(3 * triangles.size());
  piece.vertex_offset = static_cast<int32_t>(scene.vertices.size());
  piece.coloured = attributes.colours.components != 0;
  piece.dropped_triangles = indices.size() / 3 - triangles.size();
  if (flat)
    appendFlat(scene, attributes, triangles, piece);
  else
    appendSmooth(scene, attributes, triangles, piece);
  return piece;
}

}  // namespace welkin::level
