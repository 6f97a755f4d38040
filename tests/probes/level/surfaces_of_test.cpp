// SPDX-License-Identifier: Apache-2.0
// Triangles in the world from glTF: positions, fronts, dropped triangles, and emission.
#include <limits>

#include "level_text.h"
#include "probes/loader/read_scene.h"

namespace welkin::tests {
namespace {
using nlohmann::json;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Number3 vertex(const geometry::Surfaces& s, std::size_t triangle, std::size_t corner) {
  const auto& p = s.position[s.triangle[triangle].vertex[corner]];
  return {double{p[0]}, double{p[1]}, double{p[2]}};
}

bool warns(const geometry::Surfaces& s, const std::string& of) {
  return std::any_of(s.warning.begin(), s.warning.end(),
                     [&](const std::string& w) { return w.find(of) != std::string::npos; });
}

}  // namespace

TEST_CASE("SurfacesOf, NodesStandWhereTheirParentsAndTheEntryPutThem") {
  GltfText gltf;
  const int triangle = gltf.addMesh({{0, 0, 0, 1, 0, 0, 0, 2, 0}, {0, 1, 2}});
  const double h = std::sqrt(0.5);
  gltf.addNode(triangle, {{"name", "post"}, {"rotation", {0, 0, h, h}}, {"scale", {3, 1, 1}}, {"children", {1}}});
  gltf.json["nodes"].push_back({{"mesh", triangle}, {"translation", {1, 2, 3}}, {"extras", {{"role", "vegetation"}}}});
  const Folder folder;
  level::LevelFile level = levelOf(folder, {{"a.gltf", gltf.text()}});
  level.geometry[0].transform = geometry::fromEuler({100, 0, 0}, {0, f64::kPi / 2, 0}, Number3(2.0));
  const geometry::Surfaces s = loader::surfacesOf(loader::readScene(level), 1.0);
  REQUIRE(s.triangle.size() == 2);
  // The node turns x to y, three times as long, and y to -x. The entry turns x to -z and z to x, twice as large, and
  // moves 100 m east.
  checkNear(vertex(s, 0, 0), {100, 0, 0}, 1e-5);
  checkNear(vertex(s, 0, 1), {100, 6, 0}, 1e-5);
  checkNear(vertex(s, 0, 2), {100, 0, 4}, 1e-5);
  checkNear(vertex(s, 1, 0), {106, 6, 4}, 1e-5);  // (1, 2, 3) is (-2, 3, 3) turned
  checkNear(vertex(s, 1, 2), {106, 6, 8}, 1e-5);
  REQUIRE(s.object.size() == 2);
  CHECK(s.object[s.triangle[0].object].name == "post");
  CHECK(s.object[s.triangle[0].object].role == geometry::Role::fixed);
  CHECK(s.object[s.triangle[1].object].name == "node 1 \"\"");
  CHECK(s.object[s.triangle[1].object].role == geometry::Role::vegetation);
}

TEST_CASE("SurfacesOf, WhatPlacesNothingIsWarnedOf") {
  GltfText gltf;
  const int square = gltf.addMesh(squareMesh());
  gltf.addNode(square, {{"name", "palm_1"}});
  gltf.addNode(square, {{"name", "floor"}, {"scale", {1, 0, 1}}});
  gltf.addNode(square, {{"name", "hidden"}, {"scale", {0, 0, 0}}});
  const Folder folder;
  level::LevelFile level = levelOf(folder, {{"a.gltf", gltf.text()}});
  level.geometry[0].vegetation_nodes = {"palm*", "plam*"};
  const geometry::Surfaces s = loader::surfacesOf(loader::readScene(level), 1.0);
  CHECK(s.triangle.size() == 2);
  CHECK(warns(s, "object \"floor\" and 1 more are left out"));
  CHECK(warns(s, "a.gltf: vegetation_nodes: \"plam*\" fits no node or object"));
  CHECK(s.warning.size() == 2);
}

TEST_CASE("SurfacesOf, IgnoredNodesAreLeftOutWithAllBelowThem") {
  GltfText gltf;
  const int square = gltf.addMesh(squareMesh());
  gltf.addNode(square, {{"name", "floor"}});
  gltf.addNode(square, {{"name", "UCX_floor"}, {"children", {2, 3}}});
  gltf.json["nodes"].push_back({{"name", "kept by its role"}, {"mesh", square}, {"extras", {{"role", "static"}}}});
  gltf.json["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  gltf.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
  const Folder folder;
  level::LevelFile level = levelOf(folder, {{"a.gltf", gltf.text()}});
  level.geometry[0].ignore_nodes = {"UCX_*", "sky*"};
  const geometry::Surfaces s = loader::surfacesOf(loader::readScene(level), 1.0);
  CHECK(s.triangle.size() == 2);
  REQUIRE(s.object.size() == 1);
  CHECK(s.object[0].name == "floor");
  CHECK(s.light.empty());
  CHECK(warns(s, "a.gltf: ignore_nodes: \"sky*\" fits no node or object"));
  CHECK(s.warning.size() == 1);
}

TEST_CASE("SurfacesOf, MirroredSurfacesKeepTheirFront") {
  GltfText gltf;
  const int square = gltf.addMesh(squareMesh());
  gltf.addNode(square);
  gltf.addNode(square, {{"translation", {4, 0, 0}}, {"scale", {-1, 1, 1}}});
  gltf.addNode(square, {{"translation", {8, 0, 0}}, {"scale", {1, -1, 1}}});  // looks down
  const geometry::Surfaces s = surfacesOf({{"a.gltf", gltf.text()}});
  const geometry::Tracer tracer(s);
  for (const auto& [x, back] : {std::pair{0.3, false}, {4.3, false}, {8.3, true}}) {
    const auto hit = below(tracer, x, 0.4);
    REQUIRE(hit);
    CHECK(hit->back == back);
  }
}

TEST_CASE("SurfacesOf, TrianglesWithoutAreaOrNumbersAreDroppedAndCounted") {
  GltfText gltf;
  auto mesh = squareMesh();
  mesh.positions[10] = kNan;  // only in the second triangle
  mesh.indices.insert(mesh.indices.end(), {0, 1, 1, 0, 2, 1});
  const int square = gltf.addMesh(mesh);
  gltf.addNode(square);
  gltf.addNode(square, {{"translation", {0, 5, 0}}});
  gltf.addNode(gltf.addMesh(squareMesh()), {{"translation", {5e5, 0, 0}}, {"scale", {1e-9, 1, 1}}});  // too thin
  for (const bool normals : {true, false}) {
    if (!normals) gltf.json["meshes"][0]["primitives"][0]["attributes"].erase("NORMAL");
    const geometry::Surfaces s = surfacesOf({{"a.gltf", gltf.text()}});
    CHECK(s.triangle.size() == 4);
    CHECK(s.dropped_triangles == 6);
    CHECK(warns(s, "6 of 10 triangles"));
    for (const auto& p : s.position)
      for (const double c : p) CHECK(std::isfinite(c));
  }
}

TEST_CASE("SurfacesOf, ALevelHasAnEnd") {
  GltfText gltf;
  gltf.addNode(gltf.addMesh(squareMesh()), {{"name", "moon"}, {"translation", {0, 3.8e8, 0}}});
  checkSurfacesRefused({{"a.gltf", gltf.text()}}, {"moon", "380000000", "at most 1000000"});
}

TEST_CASE("SurfacesOf, MaterialsKeepEmissionSidesAndAlpha") {
  GltfText gltf;
  const auto add = [&](const char* name, const json& change) {
    const int material = gltf.addMaterial({0.1, 0.2, 0.3}, std::string(name) == "sheet");
    auto& m = gltf.json["materials"][static_cast<std::size_t>(material)];
    m["name"] = name;
    m.update(change);
    gltf.addNode(gltf.addMesh(squareMesh(), material), {{"translation", {3 * material, 0, 0}}});
    return &m;
  };
  add("sheet", json::object());
  add("lamp", {{"emissiveFactor", {0.5, 0.25, 0}},
               {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 8}}}}}});
  (*add("gone", {{"alphaMode", "MASK"}}))["pbrMetallicRoughness"]["baseColorFactor"][3] = 0.25;
  (*add("pane", {{"alphaMode", "BLEND"}}))["pbrMetallicRoughness"]["baseColorFactor"][3] = 0.75;
  (*add("solid", json::object()))["pbrMetallicRoughness"]["baseColorFactor"][3] = 0.25;
  add("glass", {{"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 0.5}}}}}});
  add("paint", {{"alphaMode", "BLEND"}});
  gltf.json["extensionsRequired"] = {"KHR_materials_emissive_strength", "KHR_materials_transmission",
                                     "KHR_materials_unlit"};
  const geometry::Surfaces s = surfacesOf({{"a.gltf", gltf.text()}});
  REQUIRE(s.material.size() == 7);
  CHECK(s.material[0].double_sided);
  CHECK_FALSE(s.material[1].double_sided);
  checkNear(s.material[1].emission, {4, 2, 0}, 0);
  checkNear(surfacesOf({{"a.gltf", gltf.text()}}, 4.0).material[1].emission, {1, 0.5, 0}, 0);  // scene units
  checkNear(s.material[1].albedo, {0.1, 0.2, 0.3}, 0);
  CHECK(s.warning.empty());
  const geometry::Tracer tracer(s);
  checkNear(tracer.passing(*below(tracer, 9.2, 0.1)), Number3(0.25), 1e-12);
  checkNear(tracer.albedo(*below(tracer, 9.2, 0.1)), {0.075, 0.15, 0.225}, 1e-12);
  checkNear(tracer.passing(*below(tracer, 12.2, 0.1)), Number3(0.0), 0);
  checkNear(tracer.passing(*below(tracer, 15.2, 0.1)), {0.05, 0.1, 0.15}, 1e-12);
  checkNear(tracer.albedo(*below(tracer, 15.2, 0.1)), {0.05, 0.1, 0.15}, 1e-12);
  CHECK_FALSE(s.material[6].letsLightThrough());  // blended, and all there
  CHECK_FALSE(below(tracer, 6.2, 0.1));           // below the cut-off everywhere
  CHECK(below(tracer, 9.2, 0.1));
  CHECK(below(tracer, 12.2, 0.1));  // opaque whatever its alpha
}

TEST_CASE("SurfacesOf, VertexColoursMultiplyTheMaterials") {
  GltfText gltf;
  auto mesh = squareMesh();
  mesh.colours = {1, 0, 0, 1, 0, 0, 0, 0.5, 1, 0, 0.5, 1};  // colours change along z
  gltf.addNode(gltf.addMesh(mesh, gltf.addMaterial({0.5, 0.5, 0.25})));
  gltf.addNode(gltf.addMesh(mesh), {{"translation", {4, 0, 0}}});
  gltf.addNode(gltf.addMesh(squareMesh()), {{"translation", {8, 0, 0}}});
  const geometry::Surfaces s = surfacesOf({{"a.gltf", gltf.text()}});
  const geometry::Tracer tracer(s);
  const double kFloats = 1e-6;
  checkNear(tracer.albedo(*below(tracer, 0.3, 0.5)), {0.125, 0.1875, 0.1875}, kFloats);
  checkNear(tracer.albedo(*below(tracer, 4.3, 0.5)), {0.25, 0.375, 0.75}, kFloats);
  checkNear(tracer.albedo(*below(tracer, 8.3, 0.5)), Number3(0.5), kFloats);  // level.toml's albedo
  mesh.colours[3] = 1.5F;
  GltfText bright;
  bright.addNode(bright.addMesh(mesh));
  checkSurfacesRefused({{"a.gltf", bright.text()}}, {"a.gltf", "COLOR_0", "1.5"});
}

TEST_CASE("SurfacesOf, LightsAreReadAsTheirNodesPlaceThem") {
  GltfText gltf;
  gltf.addNode(gltf.addMesh(squareMesh()));
  gltf.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "point"}, {"color", {1, 0.5, 0}}, {"intensity", 10}},
      {{"type", "spot"}, {"range", 2}, {"spot", {{"innerConeAngle", 0.25}, {"outerConeAngle", 0.5}}}},
      {{"type", "directional"}, {"intensity", 3}}};
  for (const int light : {0, 1, 2})
    gltf.json["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", light}}}}}});
  gltf.json["nodes"][0]["children"] = {1, 2, 3};
  gltf.json["nodes"][0]["scale"] = {2, 2, 2};
  gltf.json["nodes"][1]["translation"] = {1, 2, 3};
  gltf.json["nodes"][2]["translation"] = {3, 0, 0};
  gltf.json["nodes"][2]["rotation"] = {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)};  // -z becomes -y
  const geometry::Surfaces s = surfacesOf({{"a.gltf", gltf.text()}});
  REQUIRE(s.light.size() == 3);
  checkNear(s.light[0].position, {2, 4, 6}, 0);
  checkNear(s.light[0].intensity, {10, 5, 0}, 0);
  checkNear(surfacesOf({{"a.gltf", gltf.text()}}, 4.0).light.at(0).intensity, {2.5, 1.25, 0}, 0);  // scene units
  geometry::StaticLight spot = s.light[1];
  checkNear(spot.position, {6, 0, 0}, 0);
  checkNear(spot.intensity, Number3(1.0), 0);
  checkNear(spot.axis, {0, -1, 0}, 1e-12);
  CHECK(spot.inverse_range4 == 1.0 / 16.0);  // no scale changes it
  CHECK(spot.cone_scale * std::cos(0.25) + spot.cone_offset == Approx(1.0));
  CHECK(spot.cone_scale * std::cos(0.5) + spot.cone_offset == Approx(0.0).margin(1e-12));
  CHECK(s.light[2].directional);
  checkNear(s.light[2].intensity, Number3(3.0), 0);
  checkNear(s.light[2].axis, {0, 0, -1}, 0);
  REQUIRE(s.warning.size() == 1);
  CHECK(warns(s, "a.gltf: node 3 \"\": a directional light shines at every hour"));
  json& lights = gltf.json["extensions"]["KHR_lights_punctual"]["lights"];
  lights[0]["intensity"] = -1;
  checkSurfacesRefused({{"a.gltf", gltf.text()}}, {"node 1", "intensity"});
  lights[0] = {{"type", "point"}, {"range", -2}};
  checkSurfacesRefused({{"a.gltf", gltf.text()}}, {"lights[0]", "range = -2"});
  lights[0] = {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.5}, {"outerConeAngle", 0.5}}}};
  checkSurfacesRefused({{"a.gltf", gltf.text()}}, {"node 1", "innerConeAngle is 0.5"});
  lights[0] = {{"type", "spot"}, {"spot", {{"outerConeAngle", 1.6}}}};
  checkSurfacesRefused({{"a.gltf", gltf.text()}}, {"node 1", "outerConeAngle 1.6"});
  lights[0] = {{"type", "area"}};
  checkSurfacesRefused({{"a.gltf", gltf.text()}}, {"node 1", "type = \"area\""});
  gltf.json["nodes"][1]["extensions"]["KHR_lights_punctual"]["light"] = 3;
  checkSurfacesRefused({{"a.gltf", gltf.text()}}, {"node 1", "light 3 is none of the 3"});
}

TEST_CASE("SurfacesOf, AFileThatManyEntriesPlaceIsReadOnce") {
  GltfText gltf;
  gltf.addNode(gltf.addMesh(boxMesh()));
  const Folder folder;
  level::LevelFile level = levelOf(folder, {{"a.gltf", gltf.text()}});
  level.geometry.push_back(level.geometry[0]);
  level.geometry[1].transform.translation = {10, 0, 0};
  level.geometry[1].albedo = {0.1, 0.2, 0.3};
  level.geometry[1].role = geometry::Role::vegetation;
  const level::Scene scene = loader::readScene(level);
  CHECK(scene.vertices.size() == 36);
  CHECK(scene.files == std::vector<std::filesystem::path>{level.geometry[0].path});
  const geometry::Surfaces s = loader::surfacesOf(scene, 1.0);
  REQUIRE(s.triangle.size() == 24);
  CHECK(s.object[s.triangle[23].object].role == geometry::Role::vegetation);
  checkNear(s.material[s.triangle[0].material].albedo, Number3(0.5), 0);
  checkNear(s.material[s.triangle[23].material].albedo, {0.1, 0.2, 0.3}, 0);
}

TEST_CASE("SurfacesOf, PositionsAreTheSameFromTheCornerOfEverySector") {
  const auto levelAt = [](double x, double z) {
    GltfText gltf;
    const double half = std::sqrt(0.5);
    gltf.addNode(gltf.addMesh(boxMesh()), {{"translation", {0.1, 0.2, 0.3}}, {"rotation", {0, 0.6, 0, 0.8}}});
    gltf.addNode(gltf.addMesh(squareMesh()), {{"scale", {0.3, 7.1, 1.7}}, {"rotation", {half, half, 0, 0}}});
    gltf.json["nodes"].push_back({{"translation", {x, 0, z}}, {"children", {0, 1}}});
    gltf.json["scenes"][0]["nodes"] = {2};
    return surfacesOf({{"a.gltf", gltf.text()}});
  };
  const geometry::Surfaces home = levelAt(0, 0);
  for (const double x : {64.0, -100032.0, 900032.0}) {
    const geometry::Surfaces far = levelAt(x, -x);
    REQUIRE(far.position.size() == home.position.size());
    for (std::size_t i = 0; i < home.position.size(); ++i) {
      CHECK(far.position[i][0] - x == home.position[i][0]);
      CHECK(far.position[i][1] == home.position[i][1]);
      CHECK(far.position[i][2] + x == home.position[i][2]);
    }
  }
}

}  // namespace welkin::tests
