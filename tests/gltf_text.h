// SPDX-License-Identifier: Apache-2.0
// glTF files made by a test: meshes of its own triangles, their bytes inside the file as base64.
#pragma once

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace welkin::tests {

inline std::string base64(const std::vector<unsigned char>& bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto at = [&](std::size_t j) { return j < bytes.size() ? uint32_t{bytes[j]} : 0U; };
    const uint32_t three = at(i) << 16 | at(i + 1) << 8 | at(i + 2);
    for (std::size_t j = 0; j < 4; ++j) text += i + j > bytes.size() ? '=' : kDigits[three >> (18 - 6 * j) & 63];
  }
  return text;
}

/// Triangles with optional normals and colours (three floats a vertex each) and texture coordinates (two).
struct MeshText {
  std::vector<float> positions;
  std::vector<uint16_t> indices;
  std::vector<float> normals{};
  std::vector<float> colours{};
  std::vector<float> uv{};
};

/// A glTF model under construction; `json` may be changed before text() is called.
class GltfText {
 public:
  GltfText() {
    json["asset"] = {{"version", "2.0"}};
    json["scenes"] = {{{"nodes", nlohmann::json::array()}}};
    json["scene"] = 0;
  }

  int addMaterial(const std::vector<double>& colour, bool double_sided = false) {
    json["materials"].push_back(
        {{"doubleSided", double_sided},
         {"pbrMetallicRoughness", {{"baseColorFactor", {colour[0], colour[1], colour[2], 1.0}}}}});
    return static_cast<int>(json["materials"].size()) - 1;
  }

  int addMesh(const MeshText& mesh, int material = -1) {
    nlohmann::json primitive = {{"attributes", {{"POSITION", addFloats(mesh.positions)}}},
                                {"indices", addAccessor(mesh.indices, 5123, "SCALAR", 1)}};
    if (!mesh.normals.empty()) primitive["attributes"]["NORMAL"] = addFloats(mesh.normals);
    if (!mesh.colours.empty()) primitive["attributes"]["COLOR_0"] = addFloats(mesh.colours);
    if (!mesh.uv.empty()) primitive["attributes"]["TEXCOORD_0"] = addAccessor(mesh.uv, 5126, "VEC2", 2);
    if (material >= 0) primitive["material"] = material;
    json["meshes"].push_back({{"primitives", {primitive}}});
    return static_cast<int>(json["meshes"].size()) - 1;
  }

  /// Adds a texture of an image's file or data URI and gives it to a material as its base colour.
  void addTexture(int material, const std::string& uri) {
    json["images"].push_back({{"uri", uri}});
    setTexture(material);
  }

  /// The same of an image's bytes in the buffer.
  void addTexture(int material, const std::vector<unsigned char>& image) {
    json["images"].push_back({{"bufferView", addView(image.data(), image.size())}, {"mimeType", "image/png"}});
    setTexture(material);
  }

  /// Adds a node to the scene; `more` holds its transform, name and extras.
  void addNode(int mesh, nlohmann::json more = nlohmann::json::object()) {
    more["mesh"] = mesh;
    json["nodes"].push_back(more);
    json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
  }

  /// Adds a node with a white point light of 100 cd.
  void addPointLight(const std::vector<double>& position) {
    nlohmann::json& lights = json["extensions"]["KHR_lights_punctual"]["lights"];
    lights.push_back({{"type", "point"}, {"intensity", 100.0}});
    json["nodes"].push_back(
        {{"translation", position}, {"extensions", {{"KHR_lights_punctual", {{"light", lights.size() - 1}}}}}});
    json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
  }

  std::string text() const {
    nlohmann::json whole = json;
    whole["buffers"] = {
        {{"byteLength", bytes_.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes_)}}};
    return whole.dump();
  }

  /// The same model as .glb.
  std::string binary() const {
    nlohmann::json whole = json;
    whole["buffers"] = {{{"byteLength", bytes_.size()}}};
    std::string text = whole.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string data(bytes_.begin(), bytes_.end());
    data.resize((data.size() + 3) / 4 * 4, '\0');
    const auto word = [](std::size_t n) {
      const auto value = static_cast<uint32_t>(n);
      std::string bytes(4, '\0');
      std::memcpy(bytes.data(), &value, 4);
      return bytes;
    };
    return "glTF" + word(2) + word(28 + text.size() + data.size()) + word(text.size()) + "JSON" + text +
           word(data.size()) + std::string("BIN\0", 4) + data;
  }

  const std::vector<unsigned char>& bytes() const { return bytes_; }

  /// Adds bytes, and a bufferView of them.
  std::size_t addView(const void* values, std::size_t size) {
    while (bytes_.size() % 4 != 0) bytes_.push_back(0);
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", size}});
    const std::size_t begin = bytes_.size();
    bytes_.resize(begin + size);
    std::memcpy(bytes_.data() + begin, values, size);
    return json["bufferViews"].size() - 1;
  }

  /// Adds an accessor of values, with a bufferView of its own.
  template <typename T>
  int addAccessor(const std::vector<T>& values, int component_type, const char* type, std::size_t components) {
    json["accessors"].push_back({{"bufferView", addView(values.data(), values.size() * sizeof(T))},
                                 {"componentType", component_type},
                                 {"count", values.size() / components},
                                 {"type", type}});
    return static_cast<int>(json["accessors"].size()) - 1;
  }

  nlohmann::json json;

 private:
  int addFloats(const std::vector<float>& values) { return addAccessor(values, 5126, "VEC3", 3); }

  void setTexture(int material) {
    json["textures"].push_back({{"source", json["images"].size() - 1}});
    json["materials"][static_cast<std::size_t>(material)]["pbrMetallicRoughness"]["baseColorTexture"] = {
        {"index", json["textures"].size() - 1}};
  }

  std::vector<unsigned char> bytes_;
};

/// A square in the plane y = 0 that faces up, from -1 to 1.
inline MeshText squareMesh() {
  return {{-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1}, {0, 2, 1, 0, 3, 2}, {0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0}};
}

/// The same with u along x and v along z, from 0 to 1.
inline MeshText texturedSquareMesh() {
  MeshText mesh = squareMesh();
  mesh.uv = {0, 0, 1, 0, 1, 1, 0, 1};
  return mesh;
}

/// A box from -1 to 1, without normals: its reader makes them.
inline MeshText boxMesh() {
  return {{-1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1},
          {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 3, 7, 6, 3, 6, 2, 1, 2, 6, 1, 6, 5, 0, 4, 7, 0, 7, 3}};
}

}  // namespace welkin::tests
