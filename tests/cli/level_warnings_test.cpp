// SPDX-License-Identifier: Apache-2.0
// Warnings of a level's bake and their places. A kept sector gives the same warnings as a baked one.
#include <catch2/catch.hpp>

#include "level_text.h"

using namespace welkin::tests;
using nlohmann::json;

namespace {

std::vector<std::string> messagesOf(const std::string& report, const std::string& id) {
  std::vector<std::string> messages;
  const json whole = json::parse(report);
  for (const json& warning : whole["warnings"])
    if (warning["id"] == id) messages.push_back(warning["message"]);
  return messages;
}

}  // namespace

TEST_CASE("LevelWarnings, SayWhereAndAreTheSameOfAKeptSector") {
  const SmallLevel level;
  level.writeLevel("rays = 64", "add = [[170, 2, 30], [168.05, 2, 30.5], [40, 1, 30]]");  // in the hut, in its wall
  REQUIRE(level.bake("out") == kSectors);
  const std::string report = readBytes(level / "out/report.json");
  const auto moved = messagesOf(report, "by-hand-moved");
  const auto dropped = messagesOf(report, "by-hand-dropped");
  REQUIRE(moved.size() == 1);
  REQUIRE(moved[0].find("sector 2_0: 1 probes by hand were moved out of geometry: [168.05, 2, 30.5] by 0.") == 0);
  REQUIRE(dropped.size() == 1);
  REQUIRE(dropped[0].find(": [170, 2, 30]") != std::string::npos);
  REQUIRE(messagesOf(report, "probes-dropped").size() == 1);
  REQUIRE(level.bake("out") == 0);
  REQUIRE(readBytes(level / "out/report.json") == report);
}

TEST_CASE("LevelWarnings, NameTheFirstPlacesAndCountTheRest") {
  const SmallLevel level;
  std::string by_hand;
  for (int i = 0; i < 260; ++i)
    by_hand.append(i > 0 ? ",[" : "[").append(std::to_string(10 + 0.125 * i)).append(", 1, 20]");
  level.writeLevel("rays = 64", std::string("minimum_separation_m = 0.2\nadd = [").append(by_hand).append("]"));
  level.bake("out", {"--sectors", "0_0"});
  const std::string report = readBytes(level / "out/report.json");
  const auto dropped = messagesOf(report, "by-hand-dropped");
  const auto thinned = messagesOf(report, "probes-thinned");
  REQUIRE(dropped.size() == 1);
  REQUIRE(thinned.size() == 1);
  REQUIRE(dropped[0].find("5 probes by hand") != std::string::npos);
  REQUIRE(dropped[0].find(" more") == std::string::npos);
  REQUIRE(thinned[0].find("] and ") != std::string::npos);
  std::size_t places = 0;
  for (const char c : thinned[0]) places += c == '[' ? 1 : 0;
  REQUIRE(places == 4);
}

TEST_CASE("LevelWarnings, OfALevelThatGetsNoSector") {
  const SmallLevel level;
  GltfText model;
  model.addNode(model.addMesh(squareMesh()), {{"scale", {30, -1, 30}}});  // looks down
  std::ofstream(level / "level.gltf", std::ios::binary) << model.text();
  REQUIRE(level.bake("out") == 0);
  REQUIRE(messagesOf(readBytes(level / "out/report.json"), "no-sectors").size() == 1);
  const Run plan = runTool({"plan", level / "level.toml", "--progress", "none"});
  REQUIRE(plan.status == 0);
  REQUIRE(plan.said("no static surface faces up"));
}
