// SPDX-License-Identifier: Apache-2.0
// Changes of the order in a level's files, and of parts out of reach, cause no new bake.
#include <algorithm>
#include <catch2/catch.hpp>

#include "level_text.h"

using namespace welkin::tests;
using nlohmann::json;

namespace {

struct Placed {
  std::string file;
  double x;
};

/// Sectors -1_0 to 6_0: ground from one file, placed trees and rocks from two others.
class Garden {
 public:
  Garden() {
    GltfText ground;
    for (int i = 0; i < 8; ++i)
      ground.addNode(ground.addMesh(squareMesh(), ground.addMaterial({0.5, 0.1 * i, 0.2})),
                     {{"translation", {64 * i - 32, 0, 32}}, {"scale", {32, 1, 31}}});
    for (int i = 0; i < 12; ++i)
      ground.addNode(i % 2, {{"name", "tuft " + std::to_string(i)},
                             {"translation", {40 * i - 20, 0.5 + 0.01 * i, 20}},
                             {"scale", {1, 1, 1}},
                             {"extras", {{"role", "vegetation"}}}});
    ground_ = ground.json;
    model_ = ground;
    writeGround([](json&) {});
    for (const char* name : {"tree", "rock"}) {
      GltfText model;
      model.addNode(model.addMesh(boxMesh(), model.addMaterial({0.3, 0.3, name[0] == 't' ? 0.1 : 0.3})));
      write(name + std::string(".gltf"), model.text());
    }
  }

  template <typename Edit>
  void writeGround(const Edit& edit) {
    model_.json = ground_;
    edit(model_.json);
    write("level.gltf", model_.text());
  }

  void writeLevel(const std::vector<Placed>& placed) const {
    std::string text = "[level]\nsky = \"sky.toml\"\n[[geometry]]\nfile = \"level.gltf\"\n";
    for (const Placed& p : placed)
      text += "[[geometry]]\nfile = \"" + p.file + ".gltf\"\ntranslation = [" + std::to_string(p.x) + ", 1, 30]\n";
    write("level.toml", text + "[probes]\nspacing_m = 16\n[transfer]\nrays = 64\nreach_m = 64\n");
  }

  int bake() const { return level_.bake("out"); }

 private:
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(level_ / name, std::ios::binary) << text;
  }

  SmallLevel level_;
  json ground_;
  GltfText model_;
};

}  // namespace

TEST_CASE("LevelOrder, OfEntriesBakesNothingAgain") {
  const Garden garden;
  const std::vector<Placed> placed{{"tree", -20}, {"rock", 400}, {"tree", 420}, {"rock", 300}, {"tree", 200}};
  garden.writeLevel(placed);
  REQUIRE(garden.bake() == 8);
  std::vector<Placed> edited = placed;
  std::reverse(edited.begin(), edited.end());
  garden.writeLevel(edited);
  REQUIRE(garden.bake() == 0);
  garden.writeLevel({placed.begin() + 1, placed.end()});
  REQUIRE(garden.bake() == 2);  // the tree was in -1_0 and 20 m from 0_0
  garden.writeLevel(placed);
  REQUIRE(garden.bake() == 2);
  edited[0].file = "rock";  // at 200, in 3_0
  garden.writeLevel(edited);
  REQUIRE(garden.bake() == 3);
}

TEST_CASE("LevelOrder, OfNodesBakesNothingAgain") {
  Garden garden;
  garden.writeLevel({});
  REQUIRE(garden.bake() == 8);
  const auto nodes = [](json& model) -> json& { return model["scenes"][0]["nodes"]; };
  garden.writeGround([&](json& model) { std::reverse(nodes(model).begin(), nodes(model).end()); });
  REQUIRE(garden.bake() == 0);
  garden.writeGround([&](json& model) { nodes(model).erase(8); });  // the first tuft, at -20
  REQUIRE(garden.bake() == 2);
  garden.writeGround([&](json& model) {  // A new first node, as far away as 6_0 and 5_0.
    nodes(model).erase(8);
    json tuft = model["nodes"][8];
    tuft["translation"] = {440, 0.5, 40};
    model["nodes"].push_back(tuft);
    nodes(model).insert(nodes(model).begin(), model["nodes"].size() - 1);
  });
  REQUIRE(garden.bake() == 2);
}
