// SPDX-License-Identifier: Apache-2.0
// Reads the primitives of glTF meshes.
#include "probes/level/gltf_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace welkin::probes {

using f64::Number3;

namespace {

void setFlatNormal(Vertex* triangle) {
  const auto corner = [&](int i) {
    return Number3(double{triangle[i].position[0]}, double{triangle[i].position[1]}, double{triangle[i].position[2]});
  };
  const Number3 normal = cross(corner(1) - corner(0), corner(2) - corner(0));
  const double length = std::sqrt(dot(normal, normal));
  if (!(length > 0.0)) return;  // no area: it is never seen
  for (int i = 0; i < 3; ++i)
    for (int c = 0; c < 3; ++c) triangle[i].normal[c] = static_cast<float>(normal[c] / length);
}

}  // namespace

const std::vector<GltfPiece>& GltfMeshes::pieces(int index) {
  const auto found = meshes_.find(index);
  if (found != meshes_.end()) return found->second;
  const tinygltf::Mesh& mesh = model_.meshes[static_cast<std::size_t>(index)];
  std::vector<GltfPiece> pieces;
  for (std::size_t i = 0; i < mesh.primitives.size(); ++i)
    pieces.push_back(readPrimitive(mesh.primitives[i],
                                   fmt::format("mesh {} \"{}\" primitive {}", index, mesh.name.substr(0, 60), i)));
  return meshes_.emplace(index, std::move(pieces)).first->second;
}

void GltfMeshes::readMaterial(const tinygltf::Primitive& primitive, const std::string& what, bool coloured,
                              GltfPiece& piece) const {
  piece.albedo = coloured ? Number3(1.0) : albedo_;
  piece.double_sided = false;
  if (primitive.material < 0) return;
  if (static_cast<std::size_t>(primitive.material) >= model_.materials.size())
    reader_.refuse(what, fmt::format("material {} is none of the {}", primitive.material, model_.materials.size()));
  const tinygltf::Material& material = model_.materials[static_cast<std::size_t>(primitive.material)];
  const auto& factor = material.pbrMetallicRoughness.baseColorFactor;
  const std::string name = fmt::format("material {} \"{}\"", primitive.material, material.name.substr(0, 60));
  if (material.pbrMetallicRoughness.baseColorTexture.index >= 0)
    reader_.refuse(name, "baseColorTexture is not supported; use vertex colours");
  if (factor.size() != 4) reader_.refuse(name, "baseColorFactor must have 4 numbers");
  for (int i = 0; i < 3; ++i) {
    const double f = factor[static_cast<std::size_t>(i)];
    if (!(f >= 0.0 && f <= 1.0)) reader_.refuse(name, fmt::format("baseColorFactor holds {}, must be 0 to 1", f));
    piece.albedo[i] = f;
  }
  piece.double_sided = material.doubleSided;
  piece.roughness = material.pbrMetallicRoughness.roughnessFactor;
}

GltfPiece GltfMeshes::readPrimitive(const tinygltf::Primitive& primitive, const std::string& what) {
  if (primitive.mode != -1 && primitive.mode != TINYGLTF_MODE_TRIANGLES)
    reader_.refuse(what, fmt::format("mode {}: must be 4, triangles", primitive.mode));
  const auto attribute = [&](const char* name) {
    const auto found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? -1 : found->second;
  };
  if (attribute("POSITION") < 0) reader_.refuse(what, "has no POSITION");
  const FloatRows positions = reader_.floats(attribute("POSITION"), what + " POSITION", 3, 3, false);
  FloatRows normals;
  FloatRows colours;
  if (attribute("NORMAL") >= 0) normals = reader_.floats(attribute("NORMAL"), what + " NORMAL", 3, 3, false);
  if (attribute("COLOR_0") >= 0) colours = reader_.floats(attribute("COLOR_0"), what + " COLOR_0", 3, 4, true);
  for (const FloatRows* rows : {&normals, &colours})
    if (rows->components != 0 && rows->count != positions.count)
      reader_.refuse(what, fmt::format("has {} positions and {} {}", positions.count, rows->count,
                                       rows == &normals ? "normals" : "colours"));
  std::vector<uint32_t> indices;
  if (primitive.indices >= 0) {
    indices = reader_.indices(primitive.indices, what + " indices", positions.count);
  } else {
    if (positions.count > std::numeric_limits<uint32_t>::max()) reader_.refuse(what, "has too many vertices");
    for (std::size_t i = 0; i < positions.count; ++i) indices.push_back(static_cast<uint32_t>(i));
  }
  if (indices.size() % 3 != 0) reader_.refuse(what, fmt::format("{} indices make no triangles", indices.size()));
  GltfPiece piece{};
  readMaterial(primitive, what, colours.components != 0, piece);
  append(positions, normals, colours, indices, what, piece);
  return piece;
}

/// Without normals every triangle is flat and has its own three vertices (specification 3.7.2.1).
void GltfMeshes::append(const FloatRows& positions, const FloatRows& normals, const FloatRows& colours,
                        const std::vector<uint32_t>& indices, const std::string& what, GltfPiece& piece) {
  const bool flat = normals.components == 0;
  const std::size_t added = flat ? indices.size() : positions.count;
  constexpr std::size_t kMost = std::numeric_limits<int32_t>::max();
  if (scene_.vertices.size() + added > kMost || scene_.indices.size() + indices.size() > kMost)
    reader_.refuse(what, "the level has more than 2^31 vertices or indices");
  piece.first_index = static_cast<uint32_t>(scene_.indices.size());
  piece.index_count = static_cast<uint32_t>(indices.size());
  piece.vertex_offset = static_cast<int32_t>(scene_.vertices.size());
  const auto addVertex = [&](std::size_t i) -> Vertex& {
    Vertex vertex{{}, {0.0F, 1.0F, 0.0F}, {1.0F, 1.0F, 1.0F}};
    std::copy_n(positions.values.begin() + static_cast<std::ptrdiff_t>(3 * i), 3, vertex.position);
    const auto stride = static_cast<std::size_t>(colours.components);
    if (stride != 0) std::copy_n(colours.values.begin() + static_cast<std::ptrdiff_t>(stride * i), 3, vertex.colour);
    piece.bounds.add({double{vertex.position[0]}, double{vertex.position[1]}, double{vertex.position[2]}});
    return scene_.vertices.emplace_back(vertex);
  };
  if (!flat) {
    for (std::size_t i = 0; i < positions.count; ++i)
      std::copy_n(normals.values.begin() + static_cast<std::ptrdiff_t>(3 * i), 3, addVertex(i).normal);
    scene_.indices.insert(scene_.indices.end(), indices.begin(), indices.end());
    return;
  }
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      addVertex(indices[i + corner]);
      scene_.indices.push_back(static_cast<uint32_t>(i + corner));
    }
    setFlatNormal(&scene_.vertices[scene_.vertices.size() - 3]);
  }
}

}  // namespace welkin::probes
