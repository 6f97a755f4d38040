// SPDX-License-Identifier: Apache-2.0
// glTF: transforms, instances, colours and roles. No file makes it read outside a buffer.
#include "gltf_level.h"

namespace welkin::tests {

TEST_CASE("Gltf, NodesPlaceInstancesOfOneMesh") {
  GltfText gltf;
  const int square = gltf.addMesh(squareMesh(), gltf.addMaterial({0.1, 0.2, 0.3}));
  gltf.addNode(square, {{"translation", {1, 2, 3}}});
  gltf.addNode(square, {{"scale", {-1, 1, 1}}});  // mirrored
  const double h = std::sqrt(0.5);
  gltf.addNode(square, {{"rotation", {0, 0, h, h}}, {"scale", {2, 1, 1}}, {"children", {3}}});  // +x turns to +y
  gltf.json["nodes"].push_back({{"mesh", square}, {"translation", {1, 0, 0}}});
  const level::Scene scene = sceneOf(gltf.text(), [](level::GeometryEntry& e) {
    e.transform.translation = {0, 0, 10};
  });
  CHECK(scene.vertices.size() == 4);
  CHECK(scene.indices.size() == 6);
  REQUIRE(scene.instances.size() == 4);
  REQUIRE(scene.draws.size() == 2);
  CHECK(scene.draws[0].instance_count == 3);
  CHECK_FALSE(scene.draws[0].mirrored);
  CHECK(scene.draws[1].instance_count == 1);
  CHECK(scene.draws[1].first_instance == 3);
  CHECK(scene.draws[1].mirrored);
  CHECK(scene.instances[0].row[1][3] == 2.0F);
  CHECK(scene.instances[0].row[2][3] == 13.0F);
  CHECK(scene.instances[0].albedo[1] == 0.2F);
  const level::Instance& child = scene.instances[2];
  CHECK(child.row[1][3] == Approx(2.0));   // moved along its parent's x, which is up and twice as long
  CHECK(child.row[1][0] == Approx(2.0));   // its own x is up as well
  CHECK(child.row[0][1] == Approx(-1.0));  // its y west
  CHECK(scene.bounds.high.y == Approx(4.0));
  CHECK(scene.bounds.low.z == Approx(9.0));
}

TEST_CASE("Gltf, AMatrixIsReadByColumns") {
  GltfText gltf;
  gltf.addNode(gltf.addMesh(squareMesh()), {{"matrix", {1, 2, 3, 0, -4, 5, 6, 0, 7, -8, 9, 0, 10, 11, 12, 1}}});
  const level::Scene scene = sceneOf(gltf.text());
  REQUIRE(scene.instances.size() == 1);
  const float expected[3][4] = {{1, -4, 7, 10}, {2, 5, -8, 11}, {3, 6, 9, 12}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j) CHECK(scene.instances[0].row[i][j] == expected[i][j]);
}

TEST_CASE("Gltf, RolesComeFromExtrasThenNamesThenTheFile") {
  GltfText gltf;
  const int square = gltf.addMesh(squareMesh());
  gltf.addNode(square, {{"name", "palm_1"}});
  gltf.addNode(square, {{"name", "a palm"}});
  gltf.addNode(square, {{"name", "palm_2"}, {"extras", {{"role", "static"}}}});
  gltf.addNode(square, {{"name", "lagoon"}, {"extras", {{"role", "water"}}}, {"translation", {0, -1, 0}}});
  gltf.addNode(square, {{"name", "hull"}, {"extras", {{"role", "ignore"}}}});
  const level::Scene scene = sceneOf(gltf.text(), [](level::GeometryEntry& e) { e.vegetation_nodes = {"palm*"}; });
  REQUIRE(scene.draws.size() == 3);
  CHECK(scene.draws[0].role == geometry::Role::fixed);
  CHECK(scene.draws[0].instance_count == 2);
  CHECK(scene.draws[1].role == geometry::Role::vegetation);
  CHECK(scene.draws[2].role == geometry::Role::water);
  CHECK(scene.water.high.y == -1.0);
  CHECK(scene.bounds.low.y == 0.0);
  CHECK(scene.instances[0].albedo[0] == 0.5F);  // level.toml's albedo, as there is no material
}

TEST_CASE("Gltf, ColoursAreFloatsOrNormalisedIntegers") {
  GltfText gltf;
  auto mesh = squareMesh();
  mesh.colours = {0.25F, 0.5F, 1.0F, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  gltf.addNode(gltf.addMesh(mesh));
  const level::Scene scene = sceneOf(gltf.text());
  CHECK(scene.vertices[0].colour[1] == 0.5F);
  CHECK(scene.instances[0].albedo[0] == 1.0F);
  for (const auto& [type, expected] : {std::pair{5121, 205.0F / 255.0F}, {5123, 52429.0F / 65535.0F}}) {
    // The bytes cd cc 4c 3e .. of 0.2, read as bytes and shorts.
    mesh.colours.assign(12, 0.2F);
    GltfText integers;
    integers.addNode(integers.addMesh(mesh));
    auto& accessor = integers.json["accessors"].back();
    accessor["componentType"] = type;
    accessor["normalized"] = true;
    accessor["type"] = "VEC4";
    const level::Scene read = sceneOf(integers.text());
    CHECK(read.vertices[0].colour[0] == expected);
  }
}

TEST_CASE("Gltf, WithoutNormalsTrianglesAreFlat") {
  GltfText gltf;
  gltf.addNode(gltf.addMesh(boxMesh()));
  const level::Scene scene = sceneOf(gltf.text());
  REQUIRE(scene.vertices.size() == 36);
  for (const level::Vertex& v : scene.vertices) {
    float outward = 0.0F;
    for (int i = 0; i < 3; ++i) outward += v.normal[i] * v.position[i];
    CHECK(outward == Approx(1.0));
  }
}

TEST_CASE("Gltf, SkinsAndAnimationsStandStillAndAreWarnedOf") {
  GltfText gltf;
  gltf.addNode(gltf.addMesh(squareMesh()), {{"translation", {1, 2, 3}}});
  gltf.json["nodes"].push_back({{"name", "joint"}, {"translation", {7, 7, 7}}});
  const level::Scene plain = sceneOf(gltf.text());
  REQUIRE(plain.warnings.empty());
  gltf.json["animations"] = {{{"channels", json::array()}, {"samplers", json::array()}}};
  REQUIRE(sceneOf(gltf.text()).warnings.empty());

  gltf.json["nodes"][0]["skin"] = 0;
  gltf.json["skins"] = {{{"joints", {1}}}};  // inverseBindMatrices may be missing
  gltf.json["animations"][0] = {{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}},
                                {"samplers", {{{"input", 0}, {"output", 0}}}}};
  const level::Scene moving = sceneOf(gltf.text());
  REQUIRE(moving.warnings.size() == 2);
  CHECK_THAT(moving.warnings[0], Catch::Contains("skins: skinned meshes stand as their nodes place them"));
  CHECK_THAT(moving.warnings[1], Catch::Contains("animations: what they move stands as the nodes and weights"));
  REQUIRE(moving.vertices.size() == plain.vertices.size());
  REQUIRE(moving.instances.size() == 1);
  CHECK(moving.instances[0].row[1][3] == 2.0F);

  gltf.json["nodes"][0].erase("skin");
  gltf.json["animations"][0]["channels"][0]["target"] = {
      {"path", "pointer"},
      {"extensions", {{"KHR_animation_pointer", {{"pointer", "/nodes/0/extensions/KHR_node_visibility/visible"}}}}}};
  gltf.json["extensionsUsed"] = {"KHR_animation_pointer"};
  const level::Scene pointed = sceneOf(gltf.text());
  REQUIRE(pointed.warnings.size() == 1);
  CHECK_THAT(pointed.warnings[0], Catch::Contains("animations: what they move stands"));
}

TEST_CASE("Gltf, StripsAndFansAreTrianglesAndLinesAreLeftOut") {
  for (const auto& [mode, order] : {std::pair{5, std::vector<uint16_t>{0, 3, 1, 2}}, {6, {0, 3, 2, 1}}}) {
    GltfText gltf;
    MeshText mesh = squareMesh();
    mesh.indices = order;
    mesh.normals.clear();
    gltf.addNode(gltf.addMesh(mesh));
    json& primitives = gltf.json["meshes"][0]["primitives"];
    primitives[0]["mode"] = mode;
    primitives.push_back(primitives[0]);
    primitives[1]["mode"] = 1;
    const level::Scene scene = sceneOf(gltf.text());
    REQUIRE(scene.vertices.size() == 6);
    for (const level::Vertex& v : scene.vertices) CHECK(v.normal[1] == 1.0F);  // every triangle faces up
    REQUIRE(scene.warnings.size() == 1);
    CHECK_THAT(scene.warnings[0], Catch::Contains("primitive 1: points and lines are left out"));
  }
}

TEST_CASE("Gltf, AccessorsOutOfBoundsAreRefused") {
  checkWrong([](json& j) { j["accessors"][0]["count"] = 5; }, "5 elements of 12 bytes");
  checkWrong([](json& j) { j["accessors"][0]["count"] = 4000000000U; }, "elements of 12 bytes");
  checkWrong([](json& j) { j["accessors"][0]["byteOffset"] = 4; }, "from byte 4");
  checkWrong([](json& j) { j["accessors"][0]["byteOffset"] = 1; }, "not aligned");
  checkWrong([](json& j) { j["bufferViews"][0]["byteStride"] = 16; }, "stride 16");
  checkWrong([](json& j) { j["bufferViews"][0]["byteStride"] = 8; }, "byteStride of 8");
  checkWrong([](json& j) { j["bufferViews"][2]["byteLength"] = 4000; }, "bufferView 2");
  checkWrong([](json& j) { j["bufferViews"][0]["byteOffset"] = 1000000; }, "bufferView 0");
  checkWrong([](json& j) { j["bufferViews"][0]["buffer"] = 7; }, "buffer");
  checkWrong([](json& j) { j["accessors"][0]["bufferView"] = 9; }, "bufferView");
  checkWrong([](json& j) { j["accessors"][0]["type"] = "VEC2"; }, "2 components");
  checkWrong([](json& j) { j["accessors"][0]["componentType"] = 5123; }, "componentType 5123");
  checkWrong([](json& j) { j["accessors"][1]["componentType"] = 5126; }, "indices");
  checkWrong([](json& j) { j["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 40; }, "accessor 40");
  checkWrong([](json& j) { j["meshes"][0]["primitives"][0]["indices"] = 12; }, "accessor");
  checkWrong([](json& j) { j["accessors"][1]["count"] = 5; }, "5 indices make no triangles");
  checkWrong([](json& j) { j["accessors"][2]["count"] = 3; }, "4 positions and 3 normals");
  GltfText beyond;
  auto mesh = squareMesh();
  mesh.indices[4] = 4;
  beyond.addNode(beyond.addMesh(mesh));
  checkRefused(beyond.text(), base::ExitStatus::content, "index 4 is 4, and there are 4 vertices");
}

TEST_CASE("Gltf, WhatCannotBeDrawnIsRefusedByName") {
  checkWrong([](json& j) { j["asset"]["version"] = "1.0"; }, "asset.version = \"1.0\"");
  checkWrong([](json& j) { j["meshes"][0]["primitives"][0]["material"] = 3; }, "material 3");
  checkWrong([](json& j) { j["nodes"][0]["mesh"] = 3; }, "mesh 3");
  checkWrong([](json& j) { j["nodes"][0]["children"] = {0}; }, "node 0");
  checkWrong([](json& j) { j["nodes"][0]["children"] = {8}; }, "8 is none");
  checkWrong([](json& j) { j["nodes"][0]["extras"] = {{"role", "lava"}}; }, "lava");
  checkWrong([](json& j) { j["nodes"][0]["rotation"] = {0, 0, 0, 0}; }, "rotation is zero");
  GltfText textured;
  textured.addMaterial({1, 1, 1});
  textured.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
  textured.addNode(textured.addMesh(squareMesh(), 0));
  checkRefused(textured.text(), base::ExitStatus::content, "baseColorTexture");
}

TEST_CASE("Gltf, CutForeignAndMissingFiles") {
  const std::string whole = squareText([](json&) {});
  for (std::size_t size = 0; size < whole.size(); size += 37)
    checkRefused(whole.substr(0, size), base::ExitStatus::content, "not a whole glTF file");
  checkRefused("\x89PNG\r\n\x1a\n", base::ExitStatus::content, "not a whole glTF file");
  checkRefused("{}", base::ExitStatus::content, "asset is missing");
  checkRefused(std::string("glTF\x02\0\0\0\x40\0\0\0", 12), base::ExitStatus::content, "not a whole glTF file",
               "a.glb");
  checkRefused("solid box\n", base::ExitStatus::content, "glTF 2.0", "a.stl");
  // Buffers beside the file: a missing one is an error of the system, a cut one an error of the file.
  const Folder folder;
  GltfText gltf;
  gltf.addNode(gltf.addMesh(squareMesh()));
  json outside = json::parse(gltf.text());
  outside["buffers"][0]["uri"] = "a.bin";
  level::LevelFile level;
  level.geometry.push_back({folder.write("a.gltf", outside.dump()), {}, geometry::Role::fixed, {}});
  const auto statusNow = [&] {
    try {
      loader::readScene(level);
      return base::ExitStatus::done;
    } catch (const base::Error& e) {
      CHECK_THAT(e.what(), Catch::Contains("a.bin") || Catch::Contains(".gltf"));
      return e.status();
    }
  };
  CHECK(statusNow() == base::ExitStatus::file);
  const std::string bytes(gltf.bytes().begin(), gltf.bytes().end());
  folder.write("a.bin", bytes.substr(0, bytes.size() - 1));
  CHECK(statusNow() == base::ExitStatus::content);
  folder.write("a.bin", bytes);
  CHECK(statusNow() == base::ExitStatus::done);
  level.geometry[0].path = folder.path() / "none.gltf";
  CHECK(statusNow() == base::ExitStatus::file);
}

}  // namespace welkin::tests
