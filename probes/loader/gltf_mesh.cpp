// SPDX-License-Identifier: Apache-2.0
// Reads the primitives of glTF meshes.
#include "probes/loader/gltf_mesh.h"

#include <fmt/format.h>

#include <limits>

namespace welkin::loader {
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

}  // namespace

const std::vector<level::MeshPiece>& GltfMeshes::pieces(int index) {
  const auto found = meshes_.find(index);
  if (found != meshes_.end()) return found->second;
  const tinygltf::Mesh& mesh = model_.meshes[static_cast<std::size_t>(index)];
  std::vector<level::MeshPiece> pieces;
  for (std::size_t i = 0; i < mesh.primitives.size(); ++i)
    pieces.push_back(readPrimitive(mesh.primitives[i],
                                   fmt::format("mesh {} \"{}\" primitive {}", index, mesh.name.substr(0, 60), i)));
  return meshes_.emplace(index, std::move(pieces)).first->second;
}

level::Attributes GltfMeshes::readAttributes(const tinygltf::Primitive& primitive, int uv_set,
                                             const std::string& what) const {
  const auto accessorOf = [&](const std::string& name) {
    const auto found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? -1 : found->second;
  };
  level::Attributes result;
  if (accessorOf("POSITION") < 0) reader_.refuse(what, "has no POSITION");
  result.positions = reader_.floats(accessorOf("POSITION"), what + " POSITION", 3, 3, false);
  if (const int normal = accessorOf("NORMAL"); normal >= 0)
    result.normals = reader_.floats(normal, what + " NORMAL", 3, 3, false);
  if (const int colour = accessorOf("COLOR_0"); colour >= 0) {
    result.colours = reader_.floats(colour, what + " COLOR_0", 3, 4, true);
    requireColours(result.colours, what + " COLOR_0", reader_);
  }
  if (uv_set >= 0) {
    const std::string name = fmt::format("TEXCOORD_{}", uv_set);
    if (accessorOf(name) < 0) reader_.refuse(what, fmt::format("has no {}, which its material's texture needs", name));
    result.uv = reader_.floats(accessorOf(name), fmt::format("{} {}", what, name), 2, 2, true);
  }
  const std::pair<const level::FloatRows*, const char*> others[] = {
      {&result.normals, "normals"}, {&result.colours, "colours"}, {&result.uv, "texture coordinates"}};
  for (const auto& [rows, name] : others)
    if (rows->components != 0 && rows->count != result.positions.count)
      reader_.refuse(what, fmt::format("has {} positions and {} {}", result.positions.count, rows->count, name));
  return result;
}

level::MeshPiece GltfMeshes::readPrimitive(const tinygltf::Primitive& primitive, const std::string& what) {
  if (primitive.mode != -1 && primitive.mode != TINYGLTF_MODE_TRIANGLES)
    reader_.refuse(what, fmt::format("mode {}: must be 4, triangles", primitive.mode));
  const GltfMaterial* material = primitive.material < 0 ? nullptr : &materials_.at(primitive.material, what);
  const level::Attributes attributes = readAttributes(primitive, material == nullptr ? -1 : material->uv_set, what);
  std::vector<uint32_t> indices;
  if (primitive.indices >= 0) {
    indices = reader_.indices(primitive.indices, what + " indices", attributes.positions.count);
  } else {
    if (attributes.positions.count > std::numeric_limits<uint32_t>::max())
      reader_.refuse(what, "has too many vertices");
    for (std::size_t i = 0; i < attributes.positions.count; ++i) indices.push_back(static_cast<uint32_t>(i));
  }
  if (indices.size() % 3 != 0) reader_.refuse(what, fmt::format("{} indices make no triangles", indices.size()));
  level::MeshPiece piece = level::appendPiece(scene_, attributes, indices, fmt::format("{}: {}", reader_.file(), what));
  if (material != nullptr) piece.material = material->material;
  return piece;
}

}  // namespace welkin::loader
