// SPDX-License-Identifier: Apache-2.0
#include "probes/gltf/gltf_draco.h"

#include <draco/compression/decode.h>
#include <fmt/format.h>

#include <cstring>
#include <map>
#include <memory>
#include <optional>

#include "sky/base/error.h"
#include "sky/base/message.h"

namespace welkin::gltf {
namespace {

using Json = nlohmann::json;
using Bytes = std::vector<unsigned char>;

constexpr const char* kDraco = "KHR_draco_mesh_compression";

template <typename T>
std::optional<Bytes> valuesOf(const draco::Mesh& mesh, const draco::PointAttribute& attribute, int components) {
  std::vector<T> value(static_cast<std::size_t>(components));
  Bytes bytes(mesh.num_points() * value.size() * sizeof(T));
  for (std::uint32_t i = 0; i < mesh.num_points(); ++i) {
    const draco::AttributeValueIndex at = attribute.mapped_index(draco::PointIndex(i));
    if (at.value() >= attribute.size() ||
        !attribute.ConvertValue<T>(at, static_cast<std::int8_t>(components), value.data()))
      return std::nullopt;
    std::memcpy(bytes.data() + i * value.size() * sizeof(T), value.data(), value.size() * sizeof(T));
  }
  return bytes;
}

std::optional<Bytes> valuesOf(const draco::Mesh& mesh, const draco::PointAttribute& attribute, int component_type,
                              int components) {
  switch (component_type) {
    case 5120:
      return valuesOf<std::int8_t>(mesh, attribute, components);
    case 5121:
      return valuesOf<std::uint8_t>(mesh, attribute, components);
    case 5122:
      return valuesOf<std::int16_t>(mesh, attribute, components);
    case 5123:
      return valuesOf<std::uint16_t>(mesh, attribute, components);
    case 5126:
      return valuesOf<float>(mesh, attribute, components);
    default:
      return std::nullopt;
  }
}

/// Components of an accessor's type; 0 for one that no vertex has.
int componentsOf(const Json& accessor) {
  const std::string type = accessor.value("type", "");
  return type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : type == "SCALAR" ? 1 : 0;
}

bool isRead(const std::string& attribute) {
  return attribute == "POSITION" || attribute == "NORMAL" || attribute == "COLOR_0" ||
         attribute.starts_with("TEXCOORD_");
}

class Unpacking {
 public:
  Unpacking(Json& gltf, GltfBuffers& buffers, const std::string& file) : gltf_(gltf), buffers_(buffers), file_(file) {}

  void primitive(Json& primitive_of, const std::string& what) {
    const Json packed = primitive_of["extensions"][kDraco];
    const draco::Mesh& mesh = meshOf(packed["bufferView"].get<std::size_t>(), what);
    for (const auto& [name, id] : packed["attributes"].items()) {
      if (!isRead(name)) continue;
      const auto index = primitive_of["attributes"].find(name);
      if (index == primitive_of["attributes"].end()) refuse(what, name + " has no accessor");
      *index = attribute(mesh, packed["bufferView"].get<std::size_t>(), name, id.get<std::uint32_t>(),
                         index->get<std::size_t>(), what);
    }
    primitive_of["indices"] = indices(mesh, packed["bufferView"].get<std::size_t>());
    primitive_of["mode"] = 4;
    primitive_of["extensions"].erase(kDraco);
  }

 private:
  [[noreturn]] void refuse(const std::string& what, const std::string& why) const {
    throw base::Error(base::ExitStatus::content,
                      fmt::format("{}: {}: {}: {}", file_, what, kDraco, base::oneLine(why)));
  }

  /// The mesh in a bufferView, decoded once.
  const draco::Mesh& meshOf(std::size_t view_index, const std::string& what) {
    auto& mesh = meshes_[view_index];
    if (mesh) return *mesh;
    if (!gltf_.contains("bufferViews") || view_index >= gltf_["bufferViews"].size())
      refuse(what, fmt::format("there is no bufferView {}", view_index));
    const Json& view = gltf_["bufferViews"][view_index];
    const auto buffer = view["buffer"].get<std::size_t>();
    const std::size_t offset = view.value("byteOffset", std::size_t{0});
    const auto length = view["byteLength"].get<std::size_t>();
    if (buffer >= buffers_.size() || offset > buffers_[buffer].size() || length > buffers_[buffer].size() - offset)
      refuse(what, fmt::format("bufferView {} is not within its buffer", view_index));
    draco::DecoderBuffer bytes;
    bytes.Init(reinterpret_cast<const char*>(buffers_[buffer].data() + offset), length);
    draco::Decoder decoder;
    auto decoded = decoder.DecodeMeshFromBuffer(&bytes);
    if (!decoded.ok()) refuse(what, "its bytes are damaged: " + decoded.status().error_msg_string());
    mesh = std::move(decoded).value();
    for (std::uint32_t f = 0; f < mesh->num_faces(); ++f)
      for (int c = 0; c < 3; ++c)
        if (mesh->face(draco::FaceIndex(f))[c].value() >= mesh->num_points()) refuse(what, "its bytes are damaged");
    return *mesh;
  }

  std::size_t attribute(const draco::Mesh& mesh, std::size_t view, const std::string& name, std::uint32_t id,
                        std::size_t accessor_index, const std::string& what) {
    const auto [found, is_new] = accessors_.emplace(std::tuple(view, id, accessor_index), 0);
    if (!is_new) return found->second;
    const draco::PointAttribute* from = mesh.GetAttributeByUniqueId(id);
    if (from == nullptr) refuse(what, fmt::format("{} names attribute {}, which is not there", name, id));
    if (!gltf_.contains("accessors") || accessor_index >= gltf_["accessors"].size())
      refuse(what, fmt::format("{}: there is no accessor {}", name, accessor_index));
    Json accessor = gltf_["accessors"][accessor_index];
    const int components = componentsOf(accessor);
    if (components == 0 || components != from->num_components())
      refuse(what, fmt::format("{} has {} components, its accessor {}", name, from->num_components(), components));
    auto bytes = valuesOf(mesh, *from, accessor["componentType"].get<int>(), components);
    if (!bytes || bytes->empty()) refuse(what, name + " does not fit its accessor, or is empty");
    accessor["count"] = mesh.num_points();
    return found->second = add(std::move(accessor), std::move(*bytes));
  }

  std::size_t indices(const draco::Mesh& mesh, std::size_t view) {
    const auto [found, is_new] = indices_.emplace(view, 0);
    if (!is_new) return found->second;
    std::vector<std::uint32_t> corners;
    for (std::uint32_t f = 0; f < mesh.num_faces(); ++f)
      for (int c = 0; c < 3; ++c) corners.push_back(mesh.face(draco::FaceIndex(f))[c].value());
    Bytes bytes(corners.size() * sizeof(std::uint32_t));
    std::memcpy(bytes.data(), corners.data(), bytes.size());
    return found->second =
               add({{"componentType", 5125}, {"type", "SCALAR"}, {"count", corners.size()}}, std::move(bytes));
  }

  /// Adds an accessor of bytes of its own.
  std::size_t add(Json accessor, Bytes bytes) {
    accessor.erase("byteOffset");
    accessor.erase("sparse");
    accessor["bufferView"] = addGltfBuffer(gltf_, buffers_, std::move(bytes));
    gltf_["accessors"].push_back(std::move(accessor));
    return gltf_["accessors"].size() - 1;
  }

  Json& gltf_;
  GltfBuffers& buffers_;
  const std::string& file_;
  std::map<std::size_t, std::unique_ptr<draco::Mesh>> meshes_;
  std::map<std::tuple<std::size_t, std::uint32_t, std::size_t>, std::size_t> accessors_;
  std::map<std::size_t, std::size_t> indices_;
};

}  // namespace

void unpackDraco(Json& gltf, GltfBuffers& buffers, const std::string& file) {
  if (!gltf.contains("meshes")) return;
  Unpacking unpacking(gltf, buffers, file);
  for (std::size_t m = 0; m < gltf["meshes"].size(); ++m)
    for (std::size_t p = 0; p < gltf["meshes"][m]["primitives"].size(); ++p) {
      Json& primitive = gltf["meshes"][m]["primitives"][p];
      if (primitive.contains("extensions") && primitive["extensions"].contains(kDraco))
        unpacking.primitive(primitive, fmt::format("meshes[{}].primitives[{}]", m, p));
    }
}

}  // namespace welkin::gltf
