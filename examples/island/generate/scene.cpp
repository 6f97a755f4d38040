// SPDX-License-Identifier: Apache-2.0
#include "generate/scene.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>

#include "sky/base/error.h"

namespace welkin::island {
namespace {

using Json = nlohmann::ordered_json;

// Numbers of the glTF 2.0 specification, section 5.
constexpr int kFloat = 5126;
constexpr int kUnsignedByte = 5121;
constexpr int kUnsignedShort = 5123;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;

double rounded(double x) {
  return std::floor(x * 1e5 + 0.5) / 1e5;
}

Json array(const Vec3& v) {
  return Json::array({rounded(v.x), rounded(v.y), rounded(v.z)});
}

/// The quaternion x, y, z, w of a roll about z, then a pitch about x, then an azimuth about y.
Json rotation(const Node& node) {
  const double sy = det::sin(-node.azimuth_rad / 2), cy = det::cos(-node.azimuth_rad / 2);
  const double sx = det::sin(node.pitch_rad / 2), cx = det::cos(node.pitch_rad / 2);
  const double sz = det::sin(-node.roll_rad / 2), cz = det::cos(-node.roll_rad / 2);
  // full precision: a rotation must be of unit length
  return Json::array({cy * sx * cz + sy * cx * sz, sy * cx * cz - cy * sx * sz, cy * cx * sz - sy * sx * cz,
                      cy * cx * cz + sy * sx * sz});
}

/// One bufferView of elements of one kind, filled accessor by accessor.
struct View {
  int stride = 0;  // bytes a vertex; 0 for indices
  std::vector<std::byte> bytes;

  template <typename T>
  std::size_t append(const std::vector<T>& elements) {
    while (bytes.size() % 4 != 0) bytes.push_back(std::byte{0});
    const std::size_t offset = bytes.size();
    const auto added = std::as_bytes(std::span(elements));
    bytes.insert(bytes.end(), added.begin(), added.end());
    return offset;
  }
};

enum ViewIndex { kPositions, kNormals, kColours, kIndices };

class Encoder {
 public:
  Encoder() : views_{View{12, {}}, View{12, {}}, View{4, {}}, View{0, {}}} {}

  Json primitive(const Primitive& p) {
    Json low = Json::array();
    Json high = Json::array();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      float least = std::numeric_limits<float>::max();
      float most = -least;
      for (const auto& position : p.positions) {
        least = min(least, position[axis]);
        most = max(most, position[axis]);
      }
      low.push_back(static_cast<double>(least));
      high.push_back(static_cast<double>(most));
    }
    const Json positions = accessor(kPositions, p.positions, kFloat, "VEC3");
    accessors_.back()["min"] = low;
    accessors_.back()["max"] = high;
    const Json normals = accessor(kNormals, p.normals, kFloat, "VEC3");
    const Json colours = accessor(kColours, p.colours, kUnsignedByte, "VEC4");
    accessors_.back()["normalized"] = true;
    const Json indices = accessor(kIndices, p.indices, kUnsignedShort, "SCALAR");
    return {{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {"COLOR_0", colours}}}, {"indices", indices}};
  }

  Json accessors() const { return accessors_; }

  /// The binary file; `bufferViews` describes its parts.
  std::vector<std::byte> binary(Json& bufferViews) const {
    std::vector<std::byte> all;
    for (const View& view : views_) {
      while (all.size() % 4 != 0) all.push_back(std::byte{0});
      Json entry = {{"buffer", 0}, {"byteOffset", all.size()}, {"byteLength", view.bytes.size()}};
      if (view.stride != 0) entry["byteStride"] = view.stride;
      entry["target"] = view.stride != 0 ? kArrayBuffer : kElementArrayBuffer;
      bufferViews.push_back(entry);
      all.insert(all.end(), view.bytes.begin(), view.bytes.end());
    }
    return all;
  }

 private:
  template <typename T>
  Json accessor(ViewIndex view, const std::vector<T>& elements, int componentType, const char* type) {
    accessors_.push_back({{"bufferView", static_cast<int>(view)},
                          {"byteOffset", views_[view].append(elements)},
                          {"componentType", componentType},
                          {"count", elements.size()},
                          {"type", type}});
    return accessors_.size() - 1;
  }

  std::array<View, 4> views_;
  Json accessors_ = Json::array();
};

std::size_t find(const std::map<std::string, std::size_t>& indices, const std::string& name) {
  const auto entry = indices.find(name);
  if (entry == indices.end()) throw base::Error(base::ExitStatus::internal, "island: nothing is named '" + name + "'");
  return entry->second;
}

}  // namespace

void Scene::addRepaintedMesh(const std::string& name, const std::string& original, const std::string& material,
                             const std::string& replacement) {
  meshes_[name] = {{}, {original, material, replacement}};
}

GltfFiles Scene::encode(const std::string& binaryName) const {
  Json gltf = {{"asset", {{"version", "2.0"}, {"generator", "welkin_island"}}}};
  std::map<std::string, std::size_t> materialIndex;
  for (const Material& m : materials_) {
    materialIndex[m.name] = materialIndex.size();
    Json entry = {{"name", m.name},
                  {"pbrMetallicRoughness",
                   {{"baseColorFactor", {m.colour.x, m.colour.y, m.colour.z, 1.0}},
                    {"metallicFactor", 0.0},
                    {"roughnessFactor", m.roughness}}}};
    if (m.doubleSided) entry["doubleSided"] = true;
    gltf["materials"].push_back(entry);
  }

  Encoder encoder;
  std::map<std::string, std::map<std::string, Json>> stored;  // primitives by mesh and material
  for (const auto& [name, entry] : meshes_)
    for (const auto& [material, primitive] : entry.mesh.primitives())
      stored[name][material] = encoder.primitive(primitive);
  std::map<std::string, std::size_t> meshIndex;
  for (const auto& [name, entry] : meshes_) {
    meshIndex[name] = meshIndex.size();
    const bool isOwn = entry.repainted.original.empty();
    Json primitives = Json::array();
    for (const auto& [material, primitive] : stored[isOwn ? name : entry.repainted.original]) {
      Json painted = primitive;
      painted["material"] =
          find(materialIndex, !isOwn && material == entry.repainted.material ? entry.repainted.replacement : material);
      primitives.push_back(painted);
    }
    gltf["meshes"].push_back({{"name", name}, {"primitives", primitives}});
  }

  Json roots = Json::array();
  for (const Node& n : nodes_) {
    Json entry = {{"name", n.name}, {"mesh", find(meshIndex, n.mesh)}};
    if (!(n.translation == Vec3())) entry["translation"] = array(n.translation);
    if (n.azimuth_rad != 0.0 || n.pitch_rad != 0.0 || n.roll_rad != 0.0) entry["rotation"] = rotation(n);
    if (n.scale != 1.0) entry["scale"] = array(Vec3(n.scale));
    entry["extras"] = {{"role", n.role}};
    roots.push_back(gltf["nodes"].size());
    gltf["nodes"].push_back(entry);
  }
  gltf["scenes"] = Json::array({{{"name", "island"}, {"nodes", roots}}});
  gltf["scene"] = 0;

  GltfFiles files;
  gltf["accessors"] = encoder.accessors();
  gltf["bufferViews"] = Json::array();
  files.binary = encoder.binary(gltf["bufferViews"]);
  gltf["buffers"] = Json::array({{{"uri", binaryName}, {"byteLength", files.binary.size()}}});
  files.json = "{\n";  // one line an entry, so that diffs are readable
  bool isFirst = true;
  for (const auto& [key, value] : gltf.items()) {
    files.json += (isFirst ? "" : ",\n") + Json(key).dump() + ":";
    isFirst = false;
    if (!value.is_array()) {
      files.json += value.dump();
      continue;
    }
    for (std::size_t i = 0; i < value.size(); ++i) files.json += (i == 0 ? "[\n" : ",\n") + value[i].dump();
    files.json += "]";
  }
  files.json += "\n}\n";
  return files;
}

}  // namespace welkin::island
