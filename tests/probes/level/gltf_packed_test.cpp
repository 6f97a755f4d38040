// SPDX-License-Identifier: Apache-2.0
// glTF whose vertices and triangles are packed by EXT_meshopt_compression and KHR_draco_mesh_compression.
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

#include <set>

#include "gltf_level.h"

namespace welkin::tests {
namespace {

using Bytes = std::vector<unsigned char>;

/// The vertices of a grid in the plane y = 0, three floats each.
std::vector<float> gridPositions(int side) {
  std::vector<float> positions;
  for (int z = 0; z < side; ++z)
    for (int x = 0; x < side; ++x)
      for (const int value : {x, 0, z}) positions.push_back(static_cast<float>(value));
  return positions;
}

std::vector<unsigned int> gridIndices(unsigned int side) {
  std::vector<unsigned int> indices;
  for (unsigned int z = 0; z + 1 < side; ++z)
    for (unsigned int x = 0; x + 1 < side; ++x) {
      const unsigned int first = z * side + x;
      for (const unsigned int corner : {0U, side, 1U, 1U, side, side + 1}) indices.push_back(first + corner);
    }
  return indices;
}

constexpr int kSide = 20;

/// A grid as it is written plainly.
GltfText plainGrid() {
  GltfText gltf;
  MeshText mesh;
  mesh.positions = gridPositions(kSide);
  for (const unsigned int index : gridIndices(kSide)) mesh.indices.push_back(static_cast<uint16_t>(index));
  gltf.addNode(gltf.addMesh(mesh));
  return gltf;
}

json packed(std::size_t view, std::size_t bytes, std::size_t stride, std::size_t count, const char* mode) {
  return {{"EXT_meshopt_compression",
           {{"buffer", 0},
            {"byteOffset", view},
            {"byteLength", bytes},
            {"byteStride", stride},
            {"count", count},
            {"mode", mode}}}};
}

/// Puts packed bytes in place of bufferView `view`, which names a buffer that holds nothing.
void pack(GltfText& gltf, std::size_t view, const Bytes& bytes, std::size_t stride, std::size_t count,
          const char* mode) {
  const std::size_t at = gltf.addView(bytes.data(), bytes.size());
  const std::size_t offset = gltf.json["bufferViews"][at]["byteOffset"];
  json& plain = gltf.json["bufferViews"][view];
  plain = {{"buffer", 1}, {"byteLength", stride * count}};
  plain["extensions"] = packed(offset, bytes.size(), stride, count, mode);
}

/// A text that also has the fallback buffer.
std::string withFallback(const GltfText& gltf) {
  json whole = json::parse(gltf.text());
  whole["buffers"].push_back(
      {{"byteLength", 100000}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}});
  whole["extensionsRequired"] = {"EXT_meshopt_compression"};
  return whole.dump();
}

Bytes packedPositions() {
  const std::vector<float> positions = gridPositions(kSide);
  const std::size_t count = positions.size() / 3;
  Bytes bytes(meshopt_encodeVertexBufferBound(count, 12));
  bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), positions.data(), count, 12));
  return bytes;
}

Bytes packedIndices() {
  const std::vector<unsigned int> indices = gridIndices(kSide);
  Bytes bytes(meshopt_encodeIndexBufferBound(indices.size(), kSide * kSide));
  bytes.resize(meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), indices.data(), indices.size()));
  return bytes;
}

constexpr std::size_t kVertices = kSide * kSide;
constexpr std::size_t kIndices = 6 * (kSide - 1) * (kSide - 1);

GltfText meshoptGrid(const Bytes& positions, const Bytes& indices) {
  GltfText gltf = plainGrid();
  pack(gltf, 0, positions, 12, kVertices, "ATTRIBUTES");
  pack(gltf, 1, indices, 2, kIndices, "TRIANGLES");
  return gltf;
}

Bytes dracoGrid(int quantization_bits) {
  draco::TriangleSoupMeshBuilder builder;
  const std::vector<float> positions = gridPositions(kSide);
  const std::vector<unsigned int> indices = gridIndices(kSide);
  builder.Start(static_cast<int>(indices.size() / 3));
  const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
    builder.SetAttributeValuesForFace(position, draco::FaceIndex(static_cast<std::uint32_t>(i / 3)),
                                      positions.data() + 3 * indices[i], positions.data() + 3 * indices[i + 1],
                                      positions.data() + 3 * indices[i + 2]);
  const auto mesh = builder.Finalize();
  draco::Encoder encoder;
  encoder.SetEncodingMethod(draco::MESH_EDGEBREAKER_ENCODING);
  if (quantization_bits > 0) encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, quantization_bits);
  draco::EncoderBuffer buffer;
  REQUIRE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
  return {buffer.data(), buffer.data() + buffer.size()};
}

/// The grid with bytes of Draco instead of its accessors' own.
std::string dracoText(const Bytes& bytes, int attribute = 0) {
  GltfText gltf;
  gltf.addNode(gltf.addMesh(squareMesh()));
  const std::size_t view = gltf.addView(bytes.data(), bytes.size());
  json& primitive = gltf.json["meshes"][0]["primitives"][0];
  primitive["attributes"].erase("NORMAL");
  primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", view},
                                                           {"attributes", {{"POSITION", attribute}}}};
  gltf.json["accessors"][0].erase("bufferView");
  gltf.json["accessors"][1].erase("bufferView");
  gltf.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  return gltf.text();
}

}  // namespace

TEST_CASE("GltfPacked, MeshoptGivesTheSameGrid") {
  const level::Scene expected = sceneOf(plainGrid().text());
  // Triangles are rotated, not turned over: compare them corner by corner of a grid that the same encoder wrote.
  const level::Scene scene = sceneOf(withFallback(meshoptGrid(packedPositions(), packedIndices())));
  CHECK(scene.warnings.empty());
  CHECK(scene.bounds.high.x == kSide - 1);
  REQUIRE(scene.indices.size() == expected.indices.size());
  std::multiset<std::vector<float>> all, must;
  const auto corners = [](const level::Scene& s, std::multiset<std::vector<float>>& into) {
    for (const uint32_t i : s.indices) {
      const level::Vertex& v = s.vertices[i];
      into.insert({v.position[0], v.position[1], v.position[2], v.normal[1]});
    }
  };
  corners(scene, all);
  corners(expected, must);
  CHECK(all == must);
}

TEST_CASE("GltfPacked, MeshoptFiltersGiveUnitNormalsAndFloats") {
  GltfText gltf = plainGrid();
  std::vector<float> normals(4 * kVertices);
  for (std::size_t i = 0; i < kVertices; ++i) normals[4 * i + 1] = 1.0F;
  std::vector<int8_t> codes(4 * kVertices);
  meshopt_encodeFilterOct(codes.data(), kVertices, 4, 8, normals.data());
  Bytes bytes(meshopt_encodeVertexBufferBound(kVertices, 4));
  bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), codes.data(), kVertices, 4));
  std::vector<int8_t> unused(4 * kVertices);
  const int at = gltf.addAccessor(unused, 5120, "VEC3", 4);
  gltf.json["accessors"].back()["normalized"] = true;
  const std::size_t view = gltf.json["accessors"].back()["bufferView"];
  pack(gltf, view, bytes, 4, kVertices, "ATTRIBUTES");
  gltf.json["bufferViews"][view]["extensions"]["EXT_meshopt_compression"]["filter"] = "OCTAHEDRAL";
  gltf.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = at;
  const std::vector<float> positions = gridPositions(kSide);
  std::vector<uint32_t> exponents(positions.size());
  meshopt_encodeFilterExp(exponents.data(), kVertices, 12, 24, positions.data());
  bytes.assign(meshopt_encodeVertexBufferBound(kVertices, 12), 0);
  bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), exponents.data(), kVertices, 12));
  pack(gltf, 0, bytes, 12, kVertices, "ATTRIBUTES");
  gltf.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]["filter"] = "EXPONENTIAL";
  gltf.json["extensionsUsed"] = {"KHR_mesh_quantization"};
  const level::Scene scene = sceneOf(withFallback(gltf));
  CHECK(scene.bounds.high.x == kSide - 1);  // whole numbers have 24 bits to spare
  CHECK(scene.bounds.high.z == kSide - 1);
  CHECK(scene.bounds.high.y == 0.0);
  for (const level::Vertex& v : scene.vertices) REQUIRE(v.normal[1] == 1.0F);
}

TEST_CASE("GltfPacked, DamagedMeshoptIsRefused") {
  const Bytes positions = packedPositions();
  const Bytes indices = packedIndices();
  for (std::size_t size = 1; size < positions.size(); size += 7)
    checkRefused(
        withFallback(meshoptGrid(Bytes(positions.begin(), positions.begin() + static_cast<long>(size)), indices)),
        base::ExitStatus::content, "bufferViews[0]: EXT_meshopt_compression: ");
  for (std::size_t size = 1; size < indices.size(); size += 7)
    checkRefused(
        withFallback(meshoptGrid(positions, Bytes(indices.begin(), indices.begin() + static_cast<long>(size)))),
        base::ExitStatus::content, "bufferViews[1]: EXT_meshopt_compression: ");
  const auto wrong = [&](const char* key, const json& value, const std::string& says) {
    GltfText gltf = meshoptGrid(positions, indices);
    json& extension = gltf.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"];
    if (value.is_null())
      extension.erase(key);
    else
      extension[key] = value;
    checkRefused(withFallback(gltf), base::ExitStatus::content, says);
  };
  wrong("mode", "POINTS", "mode = \"POINTS\"");
  wrong("mode", nullptr, "mode is missing");
  wrong("filter", "QUATERNION", "filter = \"QUATERNION\" for elements of 12 bytes");
  wrong("count", 2000000000, "cannot be packed into");
  wrong("byteLength", 100000, "100000 bytes from byte");
  wrong("byteOffset", 9007199254740991, "bytes from byte 9007199254740991");
  wrong("buffer", 7, "buffer 7 is none of the 2");
  wrong("byteStride", 10, "elements of 10 bytes");
}

TEST_CASE("GltfPacked, DracoGivesTheSameGrid") {
  const level::Scene expected = sceneOf(plainGrid().text());
  for (const auto& [bits, tolerance] : {std::pair{0, 0.0}, {14, (kSide - 1) / 16383.0}}) {  // a step of 14 bits
    const level::Scene scene = sceneOf(dracoText(dracoGrid(bits)));
    CHECK(scene.warnings.empty());
    CHECK(scene.indices.size() == expected.indices.size());
    CHECK(std::abs(scene.bounds.high.x - (kSide - 1)) <= tolerance);
    CHECK(std::abs(scene.bounds.low.z) <= tolerance);
    double area = 0.0;
    for (std::size_t i = 0; i + 2 < scene.indices.size(); i += 3) {
      const auto at = [&](std::size_t c) {
        const level::Vertex& v = scene.vertices[scene.indices[i + c]];
        return f64::Number3(double{v.position[0]}, double{v.position[1]}, double{v.position[2]});
      };
      area += cross(at(1) - at(0), at(2) - at(0)).y / 2.0;  // facing up
    }
    CHECK(area == Approx((kSide - 1) * (kSide - 1)).epsilon(1e-3));
  }
}

TEST_CASE("GltfPacked, DamagedDracoIsRefused") {
  const Bytes whole = dracoGrid(11);
  const std::string says = "meshes[0].primitives[0]: KHR_draco_mesh_compression: ";
  for (std::size_t size = 1; size < whole.size(); size += 5)
    checkRefused(dracoText(Bytes(whole.begin(), whole.begin() + static_cast<long>(size))), base::ExitStatus::content,
                 says);
  checkRefused(dracoText({'D', 'R', 'A', 'C', 'O'}), base::ExitStatus::content, says + "its bytes are damaged");
  checkRefused(dracoText(whole, 3), base::ExitStatus::content, says + "POSITION names attribute 3");
}

}  // namespace welkin::tests
