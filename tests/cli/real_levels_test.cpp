// SPDX-License-Identifier: Apache-2.0
// Bakes of real levels, if WELKIN_DATA names a folder with levels/: probes wherever one can walk.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <regex>
#include <sstream>

#include "level_text.h"

using namespace welkin::tests;
using nlohmann::json;

namespace {

/// The folder of the levels. Nothing, with a warning, if there is none.
std::optional<std::string> levels() {
  if (const char* folder = std::getenv("WELKIN_DATA")) return std::string(folder) + "/levels/";
  WARN("skipped: WELKIN_DATA names no folder with levels/");
  return std::nullopt;
}

std::string geometry(const std::string& file, const std::string& more = "") {
  std::ostringstream text;
  text << "[[geometry]]\nfile = \"" << file << "\"\n" << more << "\n";
  return text.str();
}

std::string sectorsAround(int reach) {
  std::ostringstream list;
  for (int x = -reach; x < reach; ++x)
    for (int z = -reach; z < reach; ++z) list << (list.str().empty() ? "" : ",") << x << "_" << z;
  return list.str();
}

/// Bakes a level of that geometry, prints the result, and returns its report.
json bakeLevel(const std::string& name, const std::string& text, const std::string& sectors = "") {
  const Folder folder;
  folder.write("sky.toml", skyText(kUniform, "path = [[0, 0, -40], [6, 90, 0], [12, 180, 55], [18, 270, 0]]"));
  const std::string level = folder.write("level.toml", "[level]\nsky = \"sky.toml\"\n" + text);
  std::vector<std::string> words = {"bake", level, "-o", folder / "out", "--progress", "none", "--certify", "none"};
  if (!sectors.empty()) words.push_back("--sectors=" + sectors);
  const Run run = runTool(words);
  INFO(run.err);
  REQUIRE(run.status == 0);
  std::vector<std::string> validate = {"validate"};
  for (const std::string& file : filesUnder(folder / "out/sectors"))
    validate.push_back(folder / ("out/sectors/" + file));
  REQUIRE(runTool(validate).status == 0);
  json report = json::parse(readBytes(folder / "out/report.json"));
  const json timing = json::parse(readBytes(folder / "out/timing.json"));
  std::size_t probes = 0;
  std::size_t bytes = 0;
  std::size_t uncovered = 0;
  std::size_t walkable = 0;
  for (const json& s : report["sectors"]) {
    probes += s["probes"].get<std::size_t>();
    bytes += s["bytes"].get<std::size_t>();
    uncovered += s["placement"]["uncovered"].get<std::size_t>();
    walkable += s["placement"]["walkable"].get<std::size_t>();
  }
  WARN(name << ": " << report["sectors"].size() << " sectors, " << probes << " probes, " << bytes << " bytes, "
            << timing["sectors_s"] << " s, " << timing["rays_per_s"] << " rays/s; " << uncovered << " of " << walkable
            << " walkable points see no probe");
  CHECK(probes > 0);
  CHECK(uncovered <= walkable / 1000);
  return report;
}

/// The [[geometry]] of every node of a Godot scene whose name begins with `node`. Its transforms have yaw and one
/// scale; `metres` is that of the file.
std::string placed(const std::string& scene, const std::string& node, const std::string& file, double metres,
                   const std::string& more) {
  std::ifstream in(scene);
  std::string text;
  std::string line;
  bool wanted = false;
  while (std::getline(in, line)) {
    if (line.rfind("[node", 0) == 0) {
      wanted = std::regex_search(line, std::regex("name=\"" + node + "[0-9]*\" parent"));
      continue;
    }
    std::smatch found;
    if (!wanted || !std::regex_search(line, found, std::regex(R"(^transform = Transform3D\((.*)\))"))) continue;
    std::vector<double> m;
    std::stringstream numbers(found[1].str());
    for (std::string number; std::getline(numbers, number, ',');) m.push_back(std::stod(number));
    REQUIRE(m.size() == 12);
    const double yaw = std::atan2(m[2], m[0]) * 180.0 / 3.14159265358979;
    std::ostringstream keys;
    keys << "translation = [" << m[9] << ", " << m[10] << ", " << m[11] << "]\nrotation_deg = [0, " << yaw
         << ", 0]\nscale = " << metres * m[4] << "\n";
    text += geometry(file, keys.str() + more);
    wanted = false;
  }
  return text;
}

}  // namespace

TEST_CASE("RealLevels, Fortitude") {
  const auto folder = levels();
  if (!folder) return;
  const json report = bakeLevel("fortitude", geometry(*folder + "redeclipse/fortitude.obj", "scale = 0.125"));
  CHECK(report["sectors"].size() == 10);
}

TEST_CASE("RealLevels, TestCtf") {
  const auto folder = levels();
  if (!folder) return;
  const json report = bakeLevel("test_ctf", geometry(*folder + "test_ctf/test_ctf.obj", "scale = 0.125"));
  CHECK(report["sectors"].size() == 4);
}

TEST_CASE("RealLevels, TruckTownWithItsTreesAndLamps") {
  const auto folder = levels();
  if (!folder) return;
  const std::string town = *folder + "truck_town/town/";
  const std::string scene = town + "town_scene.tscn";
  const std::string trees = placed(scene, "Tree", town + "tree/scene.gltf", 0.01, "role = \"vegetation\"");
  const std::string lamps = placed(scene, "Lamp", town + "lamp/scene.gltf", 1.0, "");
  REQUIRE(std::count(trees.begin(), trees.end(), '[') == 5 * 4);
  REQUIRE(std::count(lamps.begin(), lamps.end(), '[') == 10 * 4);
  // The ground around the town is 2 km wide; the town itself lies within 128 m.
  const json report =
      bakeLevel("truck_town", geometry(town + "model/town_model.gltf") + trees + lamps, sectorsAround(2));
  CHECK(report["sectors"].size() == 16);
}

TEST_CASE("RealLevels, ATownOfTheCityKit") {
  const auto folder = levels();
  if (!folder) return;
  const std::string kit = *folder + "kenney_city/models/";
  const char* houses[] = {"building-small-a", "building-small-b", "building-small-c",
                          "building-small-d", "building-garage",  "pavement-fountain"};
  std::string town;
  constexpr int kTiles = 8;
  for (int i = 0; i < kTiles; ++i)
    for (int j = 0; j < kTiles; ++j) {
      const bool row = j % 3 == 1;
      const bool column = i % 4 == 2;
      const std::string tile = row && column      ? "road-intersection"
                               : row || column    ? "road-straight-lightposts"
                               : (i * j) % 5 == 3 ? "grass-trees-tall"
                                                  : houses[static_cast<std::size_t>(3 * i + 5 * j) % 6];
      std::ostringstream keys;
      keys << "translation = [" << 10 * i << ", 0, " << 10 * j << "]\nrotation_deg = [0, " << (row ? 90 : 0)
           << ", 0]\nscale = 10";
      town += geometry(kit + tile + ".glb", keys.str());
    }
  bakeLevel("a town of the city kit", town);
}
