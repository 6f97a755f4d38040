// SPDX-License-Identifier: Apache-2.0
// Extensions of glTF: what is read, what is warned of by name, and what is refused.
#include "gltf_level.h"

namespace welkin::tests {
namespace {

/// The warnings that hold a text.
std::vector<std::string> warningsWith(const level::Scene& scene, const std::string& text) {
  std::vector<std::string> found;
  for (const std::string& warning : scene.warnings)
    if (warning.find(text) != std::string::npos) found.push_back(warning);
  return found;
}

/// A textured square whose one texture and image are changed.
std::string texturedText(const std::function<void(json&)>& change) {
  GltfText gltf;
  gltf.addNode(gltf.addMesh(texturedSquareMesh(), gltf.addMaterial({0.25, 0.5, 0.75})));
  gltf.addTexture(0, std::vector<unsigned char>{0xab, 'K', 'T', 'X', ' ', '2', '0', 0xbb});
  change(gltf.json);
  return gltf.text();
}

void checkFactorAlone(const std::string& text, const std::string& says) {
  INFO(says);
  const level::Scene scene = sceneOf(text);
  REQUIRE(warningsWith(scene, says).size() == 1);
  CHECK(warningsWith(scene, "stands in").size() == 1);
  const auto& surface = scene.materials[scene.draws[0].material].surface;
  CHECK(surface.texture == -1);
  CHECK(surface.albedo.y == 0.5);
}

std::vector<float> translationOf(const level::Instance& instance) {
  return {instance.row[0][3], instance.row[1][3], instance.row[2][3]};
}

}  // namespace

TEST_CASE("GltfExtensions, WhatTheSceneUsesIsWarnedOfByName") {
  GltfText gltf;
  const json volume = {{"KHR_materials_volume", json::object()}, {"KHR_materials_ior", {{"ior", 1.4}}}};
  for (int i = 0; i < 3; ++i) gltf.addMaterial({1, 1, 1});
  gltf.json["materials"][1]["name"] = "glass";
  for (int i = 0; i < 3; ++i) gltf.json["materials"][static_cast<std::size_t>(i)]["extensions"] = volume;
  gltf.json["materials"][2]["extensions"]["KHR_unused"] = json::object();
  gltf.addNode(gltf.addMesh(squareMesh(), 1));
  gltf.addNode(gltf.addMesh(squareMesh(), 0), {{"extensions", {{"VENDOR_\nnode", json::object()}}}});
  gltf.json["extensions"]["EXT_lights_image_based"] = json::object();
  gltf.json["extensionsUsed"] = {"KHR_never"};
  const level::Scene scene = sceneOf(gltf.text());
  CHECK(scene.warnings.size() == 3);
  const auto volumes = warningsWith(scene, "KHR_materials_volume is not read: materials[1] \"glass\" and 1 more");
  CHECK(volumes.size() == 1);
  CHECK(warningsWith(scene, "VENDOR_\nnode is not read: nodes[1]").size() == 1);
  CHECK(warningsWith(scene, "EXT_lights_image_based is not read: the file").size() == 1);
}

TEST_CASE("GltfExtensions, ThoseOfTexturesSamplersAndImagesToo") {
  const level::Scene scene = sceneOf(texturedText([](json& j) {
    j["samplers"] = {{{"extensions", {{"X_sampler", json::object()}}}}};
    j["textures"][0]["sampler"] = 0;
    j["textures"][0]["extensions"] = {{"X_texture", json::object()}, {"KHR_texture_basisu", {{"source", 0}}}};
    j["images"][0]["extensions"] = {{"X_image", json::object()}};
    j["textures"].push_back({{"extensions", {{"X_unused", json::object()}}}});
  }));
  CHECK(warningsWith(scene, "X_unused").empty());
  CHECK(warningsWith(scene, "KHR_texture_basisu is not read").empty());  // the reader of the texture says so
  for (const char* text :
       {"X_sampler is not read: samplers[0]", "X_texture is not read: textures[0]", "X_image is not read: images[0]"})
    CHECK(warningsWith(scene, text).size() == 1);
}

TEST_CASE("GltfExtensions, ARequiredOneThatIsNotReadIsRefusedByName") {
  checkWrong(
      [](json& j) {
        j["extensionsRequired"] = {"KHR_texture_transform", "KHR_gaussian_splatting"};
      },
      "extensionsRequired: \"KHR_gaussian_splatting\" is not read");
  for (const char* name :
       {"KHR_materials_variants", "KHR_materials_ior", "KHR_mesh_quantization", "KHR_texture_basisu"})
    CHECK(sceneOf(squareText([&](json& j) { j["extensionsRequired"] = {name}; })).draws.size() == 1);
}

TEST_CASE("GltfExtensions, ATextureOfAnotherFormatLeavesTheFactor") {
  checkFactorAlone(texturedText([](json& j) {
                     j["textures"][0] = {{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}};
                   }),
                   "texture 0 has an image of KHR_texture_basisu alone, which is not read");
  checkFactorAlone(texturedText([](json& j) { j["images"][0]["mimeType"] = "image/ktx2"; }),
                   "texture 0 is in a format that is not read: image 0");
  checkFactorAlone(texturedText([](json& j) { j["textures"][0].erase("source"); }), "texture 0 has no image");
  // An image that begins as a PNG is a damaged one.
  CHECK(sceneOf(texturedText([](json& j) { j["images"][0]["mimeType"] = "image/png"; })).textures.size() == 1);
}

TEST_CASE("GltfExtensions, WithoutCoordinatesTheFactorIsLeft") {
  GltfText gltf;
  gltf.addMaterial({0.25, 0.5, 0.75});
  gltf.addNode(gltf.addMesh(squareMesh(), 0));
  gltf.addNode(gltf.addMesh(texturedSquareMesh(), 0));
  gltf.addTexture(0, std::vector<unsigned char>{0x89, 'P', 'N', 'G'});
  const level::Scene scene = sceneOf(gltf.text());
  REQUIRE(warningsWith(scene, "mesh 0 \"\" primitive 0: has no TEXCOORD_0").size() == 1);
  REQUIRE(scene.draws.size() == 2);
  const auto& bare = scene.materials[scene.draws[0].material].surface;
  const auto& textured = scene.materials[scene.draws[1].material].surface;
  CHECK(bare.texture == -1);
  CHECK(bare.albedo.z == 0.75);
  CHECK(textured.texture == 0);
}

TEST_CASE("GltfExtensions, HiddenNodesHideThoseBelow") {
  GltfText gltf;
  const int square = gltf.addMesh(squareMesh());
  const auto visible = [](bool is) { return json{{"KHR_node_visibility", {{"visible", is}}}}; };
  gltf.addNode(square, {{"extensions", visible(false)}, {"children", {2}}});
  gltf.addNode(square, {{"extensions", visible(true)}, {"translation", {0, 1, 0}}});
  gltf.json["nodes"].push_back({{"mesh", square}, {"extensions", visible(true)}});
  const level::Scene scene = sceneOf(gltf.text());
  REQUIRE(scene.instances.size() == 1);
  CHECK(translationOf(scene.instances[0]) == std::vector<float>{0, 1, 0});
  CHECK(scene.warnings.empty());
}

TEST_CASE("GltfExtensions, MorphTargetsStandAtTheirWeights") {
  GltfText gltf;
  const int square = gltf.addMesh(squareMesh());
  json& primitive = gltf.json["meshes"][0]["primitives"][0];
  const std::vector<float> up = {0, 8, 0, 0, 8, 0, 0, 8, 0, 0, 8, 0};
  const std::vector<float> east = {1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0};
  const int up_at = gltf.addAccessor(up, 5126, "VEC3", 3);
  const int east_at = gltf.addAccessor(east, 5126, "VEC3", 3);
  primitive["targets"] = {{{"POSITION", up_at}}, {{"POSITION", east_at}, {"NORMAL", east_at}}};
  gltf.json["meshes"][0]["weights"] = {0.5, 0.0};
  gltf.addNode(square);
  gltf.addNode(square, {{"weights", {0.25, 1.0}}});
  gltf.addNode(square, {{"weights", {0.25, 1.0}}});
  const level::Scene scene = sceneOf(gltf.text());
  REQUIRE(scene.draws.size() == 2);
  REQUIRE(scene.vertices.size() == 8);
  CHECK(scene.draws[1].instance_count == 2);
  const level::Vertex& half = scene.vertices[0];  // the corner (-1, 0, -1)
  CHECK(half.position[0] == -1.0F);
  CHECK(half.position[1] == 4.0F);
  const level::Vertex& both = scene.vertices[4];
  CHECK(both.position[0] == 0.0F);
  CHECK(both.position[1] == 2.0F);
  CHECK(both.normal[0] == Approx(std::sqrt(0.5)));  // (1, 1, 0), made unit
  CHECK(both.normal[1] == Approx(std::sqrt(0.5)));
  gltf.json["meshes"][0]["weights"] = {1, 1, 1};
  checkRefused(gltf.text(), base::ExitStatus::content, "3 weights for 2 morph targets");
  gltf.json["meshes"][0]["weights"] = {1};
  gltf.json["meshes"][0]["primitives"][0]["targets"][0]["POSITION"] = gltf.addAccessor(up, 5126, "VEC3", 12);
  gltf.json["accessors"].back()["count"] = 3;
  checkRefused(gltf.text(), base::ExitStatus::content, "target 0 POSITION: has 3 elements for 4 vertices");
}

TEST_CASE("GltfExtensions, SparseValuesReplaceThoseThatAreStored") {
  const auto sparse = [](std::size_t place, bool stored) {
    GltfText gltf;
    gltf.addNode(gltf.addMesh(squareMesh()));
    const auto at = gltf.addView(&place, 2);
    const float value[3] = {-1, 5, -1};
    json& accessor = gltf.json["accessors"][0];
    accessor["sparse"] = {{"count", 1},
                          {"indices", {{"bufferView", at}, {"componentType", 5123}}},
                          {"values", {{"bufferView", gltf.addView(value, sizeof(value))}}}};
    if (!stored) accessor.erase("bufferView");
    return gltf.text();
  };
  const level::Scene scene = sceneOf(sparse(0, true));
  CHECK(scene.vertices[0].position[1] == 5.0F);
  CHECK(scene.vertices[1].position[0] == 1.0F);
  checkRefused(sparse(4, true), base::ExitStatus::content, "sparse index 0 is 4, and there are 4 elements");
  // Without bytes all corners are at the origin, and no triangle has an area.
  GltfText zeros;
  zeros.addNode(zeros.addMesh(squareMesh()));
  zeros.addNode(zeros.addMesh(squareMesh()));
  zeros.json["accessors"][0].erase("bufferView");
  CHECK(sceneOf(zeros.text()).draws[0].dropped_triangles == 2);
  zeros.json["accessors"][0]["count"] = 4000000000000;
  checkRefused(zeros.text(), base::ExitStatus::content, "without a bufferView: at most 16777216");
}

TEST_CASE("GltfExtensions, SparseIndicesRise") {
  for (const auto& [second, message] :
       {std::pair(std::uint16_t{1}, "sparse index 1 is 1, and must be larger than the one before it"),
        std::pair(std::uint16_t{2}, "")}) {
    GltfText gltf;
    gltf.addNode(gltf.addMesh(squareMesh()));
    const std::uint16_t at[2] = {1, second};
    const float values[6] = {1, 5, -1, 1, 5, 1};
    gltf.json["accessors"][0]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", gltf.addView(at, sizeof(at))}, {"componentType", 5123}}},
        {"values", {{"bufferView", gltf.addView(values, sizeof(values))}}}};
    if (*message != 0)
      checkRefused(gltf.text(), base::ExitStatus::content, message);
    else
      CHECK(sceneOf(gltf.text()).vertices[2].position[1] == 5.0F);
  }
}

TEST_CASE("GltfExtensions, IndicesMayBeSparseAlone") {
  const auto square = [](bool sparse, std::uint64_t count) {
    GltfText gltf;
    gltf.addNode(gltf.addMesh(squareMesh()));
    const std::size_t place = gltf.json["meshes"][0]["primitives"][0]["indices"].get<std::size_t>();
    json& accessor = gltf.json["accessors"][place];
    const std::uint8_t at[5] = {1, 2, 3, 4, 5};
    const std::uint32_t values[5] = {1, 2, 0, 2, 3};
    accessor["componentType"] = 5125;
    accessor["count"] = count;
    accessor.erase("bufferView");
    if (sparse)
      accessor["sparse"] = {{"count", 5},
                            {"indices", {{"bufferView", gltf.addView(at, sizeof(at))}, {"componentType", 5121}}},
                            {"values", {{"bufferView", gltf.addView(values, sizeof(values))}}}};
    return gltf.text();
  };
  CHECK(sceneOf(square(true, 6)).indices == std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3});
  checkRefused(square(false, 6), base::ExitStatus::content, "its 2 triangles are without area, or not finite");
  checkRefused(square(false, 4000000000), base::ExitStatus::content,
               "4000000000 indices without a bufferView: at most 16777216 are allowed");
}

TEST_CASE("GltfExtensions, QuantizedMeshesAreRead") {
  GltfText gltf;
  gltf.addMaterial({1, 1, 1});
  gltf.addNode(gltf.addMesh(texturedSquareMesh(), 0), {{"scale", {2, 2, 2}}});
  gltf.addTexture(0, std::vector<unsigned char>{0x89, 'P', 'N', 'G'});
  json& attributes = gltf.json["meshes"][0]["primitives"][0]["attributes"];
  const std::vector<int16_t> places = {-30, 1, -30, 0, 30, 1, -30, 0, 30, 1, 30, 0, -30, 1, 30, 0};
  attributes["POSITION"] = gltf.addAccessor(places, 5122, "VEC3", 4);
  gltf.json["bufferViews"].back()["byteStride"] = 8;
  const std::vector<int8_t> normals = {-128, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0, 0};
  attributes["NORMAL"] = gltf.addAccessor(normals, 5120, "VEC3", 4);
  gltf.json["bufferViews"].back()["byteStride"] = 4;
  gltf.json["accessors"].back()["normalized"] = true;
  const std::vector<uint8_t> uv = {0, 3, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0};
  attributes["TEXCOORD_0"] = gltf.addAccessor(uv, 5121, "VEC2", 4);
  gltf.json["bufferViews"].back()["byteStride"] = 4;
  checkRefused(gltf.text(), base::ExitStatus::content, "POSITION: componentType 5122: must be float");
  gltf.json["extensionsUsed"] = {"KHR_mesh_quantization"};
  gltf.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  const level::Scene scene = sceneOf(gltf.text());
  CHECK(scene.bounds.low.x == -60.0);
  CHECK(scene.bounds.high.y == 2.0);
  CHECK(scene.vertices[0].normal[0] == -1.0F);  // -128 is -1 as well as -127
  CHECK(scene.vertices[0].normal[1] == 1.0F);
  CHECK(scene.vertices[0].uv[1] == 3.0F);
}

TEST_CASE("GltfExtensions, InstancesArePlacedInTheirNode") {
  GltfText gltf;
  gltf.addNode(gltf.addMesh(squareMesh()), {{"translation", {0, 10, 0}}, {"scale", {2, 2, 2}}});
  const std::vector<float> moves = {0, 0, 0, 40, 0, 0};
  const std::vector<float> scales = {1, 1, 1, 3, 1, 1};
  const std::vector<int16_t> turns = {0, 0, 0, 32767, 0, 23170, 0, 23170};  // a quarter turn about y
  json& extension = gltf.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
  extension["TRANSLATION"] = gltf.addAccessor(moves, 5126, "VEC3", 3);
  extension["SCALE"] = gltf.addAccessor(scales, 5126, "VEC3", 3);
  extension["ROTATION"] = gltf.addAccessor(turns, 5122, "VEC4", 4);
  gltf.json["accessors"].back()["normalized"] = true;
  const level::Scene scene = sceneOf(gltf.text());
  REQUIRE(scene.instances.size() == 2);
  CHECK(scene.vertices.size() == 4);
  CHECK(translationOf(scene.instances[0]) == std::vector<float>{0, 10, 0});
  CHECK(translationOf(scene.instances[1]) == std::vector<float>{80, 10, 0});
  CHECK(scene.instances[1].row[2][0] == Approx(-6.0));  // its x points to -z: 2 times 3
  CHECK(scene.instances[1].row[0][2] == Approx(2.0));
  CHECK(scene.warnings.empty());
  extension["SCALE"] = gltf.addAccessor(std::vector<float>{1, 1, 1}, 5126, "VEC3", 3);
  checkRefused(gltf.text(), base::ExitStatus::content, "has 2 translations, 2 rotations and 1 scales");
  extension = json::object();
  checkRefused(gltf.text(), base::ExitStatus::content, "has none of TRANSLATION");
}

}  // namespace welkin::tests
