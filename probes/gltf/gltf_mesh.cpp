// SPDX-License-Identifier: Apache-2.0
// Reads the primitives of glTF meshes.
#include "probes/gltf/gltf_mesh.h"

#include <fmt/format.h>

#include <limits>

#include "probes/gltf/gltf_morph.h"
#include "sky/base/message.h"

namespace welkin::gltf {
namespace {

/// Throws if a finite colour is out of the range of an albedo. The margin allows for rounding by exporters.
void requireColours(const level::FloatRows& colours, const std::string& what, const AccessorReader& reader) {
  constexpr float kMost = 1.001F;
  for (std::size_t i = 0; i < colours.values.size(); ++i)
    if (colours.values[i] < 0.0F ||
        (colours.values[i] > kMost && colours.values[i] <= std::numeric_limits<float>::max()))
      reader.refuse(what, fmt::format("element {} is {}, must be 0 to 1",
                                      i / static_cast<std::size_t>(colours.components), colours.values[i]));
}

/// The triangles of a strip or a fan. glTF 2.0, 3.7.2.1.
std::vector<uint32_t> trianglesOf(const std::vector<uint32_t>& v, bool fan) {
  std::vector<uint32_t> triangles;
  for (std::size_t i = 0; i + 2 < v.size(); ++i) {
    const std::size_t odd = i % 2;
    if (fan)
      triangles.insert(triangles.end(), {v[i + 1], v[i + 2], v[0]});
    else
      triangles.insert(triangles.end(), {v[i], v[i + 1 + odd], v[i + 2 - odd]});
  }
  return triangles;
}

}  // namespace

const std::vector<level::MeshPiece>& GltfMeshes::pieces(int index, const std::vector<double>& weights) {
  const tinygltf::Mesh& mesh = model_.meshes[static_cast<std::size_t>(index)];
  const std::pair key(index, weights.empty() ? mesh.weights : weights);
  const auto found = meshes_.find(key);
  if (found != meshes_.end()) return found->second;
  std::vector<level::MeshPiece> pieces;
  for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
    const std::string what = fmt::format("mesh {} \"{}\" primitive {}", index, base::shortened(mesh.name, 60), i);
    const int mode = mesh.primitives[i].mode;
    if (mode >= TINYGLTF_MODE_POINTS && mode <= TINYGLTF_MODE_LINE_STRIP)
      scene_.warnings.push_back(fmt::format("{}: {}: points and lines are left out", reader_.file(), what));
    else
      pieces.push_back(readPrimitive(mesh.primitives[i], key.second, what));
  }
  return meshes_.emplace(key, std::move(pieces)).first->second;
}

level::Attributes GltfMeshes::readAttributes(const tinygltf::Primitive& primitive, int uv_set,
                                             const std::string& what) const {
  const auto accessorOf = [&](const std::string& name) {
    const auto found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? -1 : found->second;
  };
  level::Attributes result;
  if (accessorOf("POSITION") < 0) reader_.refuse(what, "has no POSITION");
  result.positions = reader_.floats(accessorOf("POSITION"), what + " POSITION", 3, 3, Integers::quantized);
  if (const int normal = accessorOf("NORMAL"); normal >= 0)
    result.normals = reader_.floats(normal, what + " NORMAL", 3, 3, Integers::quantized);
  if (const int colour = accessorOf("COLOR_0"); colour >= 0) {
    result.colours = reader_.floats(colour, what + " COLOR_0", 3, 4, Integers::fractions);
    requireColours(result.colours, what + " COLOR_0", reader_);
  }
  if (uv_set >= 0) {
    const std::string name = fmt::format("TEXCOORD_{}", uv_set);
    result.uv = reader_.floats(accessorOf(name), fmt::format("{} {}", what, name), 2, 2,
                               reader_.quantized() ? Integers::quantized : Integers::fractions);
  }
  const std::pair<const level::FloatRows*, const char*> others[] = {
      {&result.normals, "normals"}, {&result.colours, "colours"}, {&result.uv, "texture coordinates"}};
  for (const auto& [rows, name] : others)
    if (rows->components != 0 && rows->count != result.positions.count)
      reader_.refuse(what, fmt::format("has {} positions and {} {}", result.positions.count, rows->count, name));
  return result;
}

GltfMaterial GltfMeshes::materialOf(const tinygltf::Primitive& primitive, const std::string& what) {
  GltfMaterial material = materials_.at(primitive.material, what);
  const std::string name = fmt::format("TEXCOORD_{}", material.uv_set);
  if (material.uv_set < 0 || primitive.attributes.count(name) != 0) return material;
  scene_.warnings.push_back(
      fmt::format("{}: {}: has no {}: the factor of its material \"{}\" stands in for the texture", reader_.file(),
                  what, name, model_.materials[static_cast<std::size_t>(primitive.material)].name));
  return materials_.withoutTexture(primitive.material);
}

level::MeshPiece GltfMeshes::readPrimitive(const tinygltf::Primitive& primitive, const std::vector<double>& weights,
                                           const std::string& what) {
  std::optional<GltfMaterial> material;
  if (primitive.material >= 0) material = materialOf(primitive, what);
  const int uv_set = material ? material->uv_set : -1;
  level::Attributes attributes = readAttributes(primitive, uv_set, what);
  addMorphTargets(primitive, weights, uv_set, reader_, what, attributes);
  std::vector<uint32_t> indices;
  if (primitive.indices >= 0) {
    indices = reader_.indices(primitive.indices, what + " indices", attributes.positions.count);
  } else {
    if (attributes.positions.count > std::numeric_limits<uint32_t>::max())
      reader_.refuse(what, "has too many vertices");
    for (std::size_t i = 0; i < attributes.positions.count; ++i) indices.push_back(static_cast<uint32_t>(i));
  }
  if (primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP || primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN)
    indices = trianglesOf(indices, primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN);
  if (indices.size() % 3 != 0) reader_.refuse(what, fmt::format("{} indices make no triangles", indices.size()));
  level::MeshPiece piece = level::appendPiece(scene_, attributes, indices, fmt::format("{}: {}", reader_.file(), what));
  if (material) piece.material = material->material;
  return piece;
}

}  // namespace welkin::gltf
