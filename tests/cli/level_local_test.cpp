// SPDX-License-Identifier: Apache-2.0
// The bake of a level's local transfer: the sectors that get it, and the same bytes by every way of baking.
#include <catch2/catch.hpp>
#include <fstream>

#include "level_text.h"

using namespace welkin::tests;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

json sectorOf(const SmallLevel& level, const std::string& out, const std::string& name) {
  const Run run = runTool({"inspect", level / (out + "/sectors/sector_" + name + ".welkin"), "--json"});
  INFO(run.err);
  REQUIRE(run.status == 0);
  return json::parse(run.out)["sector"];
}

/// Sectors with local transfer, according to the bytes in the output of inspect and in the report.
std::vector<std::string> sectorsWithLocal(const SmallLevel& level, const std::string& out) {
  std::vector<std::string> names;
  const json whole = json::parse(readBytes(level / (out + "/report.json")));
  for (const json& report : whole["sectors"]) {
    const std::string name = report["sector"];
    const json sector = sectorOf(level, out, name);
    const bool has = !report["error"]["local"].is_null();
    INFO(name);
    REQUIRE(sector["bytes"]["local"] == report["local_bytes"]);
    REQUIRE((report["local_bytes"] > 0) == has);
    REQUIRE(sector["virtual_lights"].empty() == !has);
    if (has) names.push_back(name);
  }
  return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("LevelLocal, SettingAndLightsSayWhichSectorsHaveIt") {
  const SmallLevel level;
  level.bake("out");
  REQUIRE(sectorsWithLocal(level, "out").empty());  // "auto", and no light
  const auto without = fs::file_size(level / "out/sectors/sector_0_0.welkin");
  level.writeLevel("rays = 64\nlocal_lights = false");
  REQUIRE(level.bake("out") == kSectors);
  REQUIRE(fs::file_size(level / "out/sectors/sector_0_0.welkin") <= without + 8);
  level.writeLevel("rays = 64\nlocal_lights = true");
  REQUIRE(level.bake("out") == kSectors);
  REQUIRE(sectorsWithLocal(level, "out") == Names{"-1_0", "0_0", "1_0", "2_0"});
  level.writeLevel("rays = 64\nlocal_lights = [\"1_0\", \"2_0\"]");
  REQUIRE(level.bake("out") == 2);
  REQUIRE(sectorsWithLocal(level, "out") == Names{"1_0", "2_0"});
  level.writeLevel("rays = 64");
  level.writeHut(170.0, 130.0);  // in 2_0, and within 64 m of 1_0
  level.bake("out");
  REQUIRE(sectorsWithLocal(level, "out") == Names{"1_0", "2_0"});
  level.writeLevel("rays = 64\nbounces = 0");
  level.bake("out");
  REQUIRE(sectorsWithLocal(level, "out").empty());  // nothing bounces
  REQUIRE(runTool({"validate", level / "out"}).status == 0);
}

TEST_CASE("LevelLocal, EveryByteIsExplained") {
  const SmallLevel level;
  level.writeLevel("rays = 64\nlocal_lights = true");
  const Run plan = runTool({"plan", level / "level.toml", "--json"});
  REQUIRE(plan.status == 0);
  level.bake("out");
  const json sector = sectorOf(level, "out", "2_0");
  std::size_t transfers = 0;
  for (const json& probe : sector["probes"]) transfers += probe["local_count"].get<std::size_t>();
  const std::size_t lights = sector["virtual_lights"].size();
  REQUIRE(transfers > sector["probes"].size());  // Neighbours count too.
  const json& local = sector["error"]["local"];
  REQUIRE(local["kept"] == transfers);
  REQUIRE(local["dropped"] == 0);
  REQUIRE(local["sampling"] > 0.0);
  REQUIRE(local["sampling_probe"] < sector["probes"].size());
  REQUIRE(local["rays"] > 0);
  REQUIRE(local["rays"] < sector["rays"]);
  const json& bytes = sector["bytes"];
  REQUIRE(bytes["local"] == sector["probes"].size() + 12 * lights + 16 * transfers);
  const std::pair<const char*, std::size_t> arrays[] = {{"local_position", 12 * lights},
                                                        {"local_count", sector["probes"].size()},
                                                        {"local_light", 2 * transfers},
                                                        {"local_scale", 2 * transfers},
                                                        {"local_radiance", 12 * transfers}};
  for (const auto& [name, count] : arrays) REQUIRE(bytes[name] == count);
  // The sources include those of sector 1_0 and none of 0_0.
  double least_x = 1e9;
  for (const json& light : sector["virtual_lights"]) least_x = std::min(least_x, light[0].get<double>());
  REQUIRE(least_x >= 64.0);
  REQUIRE(least_x < 128.0);
  std::size_t explained = 0;
  for (const char* part : {"probes", "grid", "occlusion", "rooms", "cuts", "local", "settings", "header", "structure"})
    explained += bytes[part].get<std::size_t>();
  REQUIRE(explained == bytes["total"]);
  REQUIRE(bytes["structure"] < 2048);
  const json sectors = json::parse(plan.out)["sectors"];
  for (const json& planned : sectors) {
    REQUIRE(planned["local"] == true);
    if (planned["sector"] == "2_0") REQUIRE(planned["bytes"] >= bytes["total"]);
  }
  level.writeLevel("rays = 64\nlocal_lights = false");
  level.bake("without");
  REQUIRE(sector["rays"] == sectorOf(level, "without", "2_0")["rays"].get<int>() + local["rays"].get<int>());
  const Run text = runTool({"inspect", level / "out/sectors/sector_2_0.welkin"});
  REQUIRE(text.out.find(std::to_string(transfers) + " transfers") != std::string::npos);
  REQUIRE(text.out.find("local_radiance") != std::string::npos);
}

TEST_CASE("LevelLocal, SampleShowsDynamicLights") {
  const SmallLevel level;
  level.writeLevel("rays = 64\nlocal_lights = true");
  level.bake("out");
  const json at = sectorOf(level, "out", "1_0")["virtual_lights"][0];
  std::string place;
  for (const json& coordinate : at) place += (place.empty() ? "" : ",") + coordinate.dump();
  const auto sample = [&](const std::vector<std::string>& lights) {
    std::vector<std::string> command = {"sample", level / "out", "--time", "12", "--position", place, "--json"};
    command.insert(command.end(), {"--normal", "0,-1,0"});
    for (const std::string& light : lights) command.insert(command.end(), {"--light", light});
    return runTool(command);
  };
  const auto localOf = [](const Run& run) {
    REQUIRE(run.status == 0);
    return json::parse(run.out)["components"]["local"].get<std::vector<double>>();
  };
  const Run dark = sample({}), lit = sample({place + ",10,0,30"});
  REQUIRE(localOf(dark) == std::vector<double>{0, 0, 0});
  REQUIRE(lit.err.empty());
  const auto one = localOf(lit), both = localOf(sample({place + ",10,0,30", place + ",20,0,0,0.1"}));
  REQUIRE(one[0] > 0.0);
  REQUIRE(one[1] == 0.0);
  REQUIRE(both[0] == Approx(3.0 * one[0]));
  REQUIRE(both[2] == Approx(one[2]));
  const Run far = sample({"0,900,0,1,1,1"});
  REQUIRE(localOf(far) == std::vector<double>{0, 0, 0});
  REQUIRE(far.said("welkin: warning: 1 of 1 lights are left out: no virtual light is within 64 m"));
  const Run sphere = sample({place + ",1,1,1,0.5"});
  REQUIRE(sphere.said("welkin: warning: the RADIUS of 1 lights is left out: to probes a light is a point"));
  REQUIRE(localOf(sphere) == localOf(sample({place + ",1,1,1"})));
  REQUIRE(sample({"1,2,3"}).status == 1);
  const Run nowhere = runTool({"sample", level / "out", "--time", "12", "--light", place + ",1,1,1"});
  REQUIRE(nowhere.status == 1);
  REQUIRE(nowhere.said("--light: needs --position and --normal, or --points"));
}

TEST_CASE("LevelLocal, EveryTransferIsShown") {
  const SmallLevel level;
  level.writeLevel("rays = 4096\nlocal_lights = true");
  std::string text = readBytes(level / "level.toml");
  text.insert(text.find("[probes]"), "albedo = [0.5, 0.25, 0.75]\n");
  std::ofstream(level / "level.toml") << text;
  level.bake("out", {"--sectors", "0_0"});
  const json sector = sectorOf(level, "out", "0_0");
  const json& lights = sector["virtual_lights"];
  std::size_t own = 0;
  for (const json& probe : sector["probes"]) {
    REQUIRE(probe["local"].size() == probe["local_count"]);
    int before = -1;
    for (const json& transfer : probe["local"]) {
      const int light = transfer["light"];
      REQUIRE(light > before);
      REQUIRE(light < static_cast<int>(lights.size()));
      before = light;
      for (const auto& [channel, albedo] : {std::pair("r", 0.5), std::pair("g", 0.25), std::pair("b", 0.75)}) {
        const auto radiance = transfer["radiance"][channel].get<std::vector<double>>();
        REQUIRE(radiance.size() == 4);
        REQUIRE(radiance[0] >= 0.0);
        // The probe's own light, 1 m above open ground that is lit as from 2 m. A surface at an angle whose cosine is c
        // has the radiance albedo / pi times c / 4 within 60 degrees and c^3 beyond.
        const auto away = [&](int axis) {
          return std::abs(lights[static_cast<std::size_t>(light)][axis].get<double>() -
                          probe["position"][axis].get<double>());
        };
        if (away(0) + away(1) + away(2) > 0.01) continue;
        ++own;
        const double within = (1.0 - 1.0 / 4) / 2 / 4;
        const double beyond = 1.0 / 16 / 4;
        REQUIRE(radiance[0] == Approx(0.28209 * 2 * albedo * (within + beyond)).epsilon(0.03));
        REQUIRE(radiance[1] == Approx(-0.48860 * 2 * albedo * ((1.0 - 1.0 / 8) / 3 / 4 + 1.0 / 32 / 5)).epsilon(0.03));
        REQUIRE(std::abs(radiance[2]) < 0.03 * radiance[0]);
        REQUIRE(std::abs(radiance[3]) < 0.03 * radiance[0]);
      }
    }
  }
  REQUIRE(own == 3 * sector["probes"].size());
}

TEST_CASE("LevelLocal, TracesWhatTheBudgetTakes") {
  const SmallLevel level;
  level.writeLevel("rays = \"auto\"\nlocal_lights = true");
  std::uint64_t rays = 0;
  for (const std::string budget : {"0.5", "0.1"}) {
    REQUIRE(level.bake("out", {"--max-error", budget, "--sectors", "0_0"}) == 1);
    const json error = sectorOf(level, "out", "0_0")["error"]["local"];
    REQUIRE(error["sampling"] <= std::stod(budget));
    REQUIRE(error["rays"] > rays);
    rays = error["rays"];
    REQUIRE(error == json::parse(readBytes(level / "out/report.json"))["sectors"][0]["error"]["local"]);
    level.bake("one", {"--max-error", budget, "--sectors", "0_0", "--threads", "1"});
    REQUIRE(readBytes(level / "one/sectors/sector_0_0.welkin") == readBytes(level / "out/sectors/sector_0_0.welkin"));
  }
}

TEST_CASE("LevelLocal, ASectorPastTheBudgetIsNamed") {
  // Two probes beside the hut, with a million paths each.
  const SmallLevel level;
  level.writeLevel("rays = \"auto\"\nlocal_lights = true\nsun = \"none\"\nbounces = 1\nreach_m = 8",
                   "add = [[166, 1, 28], [166, 1, 34]]\nremove = [[-1000, -1000, -1000, 1000, 1000, 1000]]");
  for (const auto& [budget, expected] : {std::pair("0.2", 0), std::pair("0.0001", 1)}) {
    level.bake("out", {"--max-error", budget, "--sectors", "2_0"});
    const json report = json::parse(readBytes(level / "out/report.json"));
    int named = 0;
    for (const json& warning : report["warnings"])
      if (warning["id"] == "hard-sector" && warning["sector"] == "2_0" &&
          warning["message"].get<std::string>().find("of the local transfer to probe ") != std::string::npos)
        ++named;
    REQUIRE(named == expected);
    REQUIRE((report["sectors"][0]["error"]["local"]["total"] > std::stod(budget)) == (expected == 1));
  }
}

TEST_CASE("LevelLocal, SameBytesForAnyThreadsShardsAndOrder") {
  const SmallLevel level;
  level.writeLevel("rays = 64\nlocal_lights = true");
  level.bake("one", {"--threads", "1"});
  level.bake("all");
  requireSame(level.path() / "one", level.path() / "all");
  REQUIRE(readBytes(level / "one/report.json") == readBytes(level / "all/report.json"));
  for (const char* shard : {"1/2", "0/2"}) REQUIRE(runTool(level.command("shards", {"--shard", shard})).status == 0);
  REQUIRE(runTool({"merge", level / "shards"}).status == 0);
  requireSame(level.path() / "one", level.path() / "shards");
  for (const char* sector : {"2_0", "-1_0", "1_0", "0_0"}) level.bake("named", {"--sectors", sector});
  requireSame(level.path() / "one", level.path() / "named");
}

TEST_CASE("LevelLocal, WhatLiesBeyondReachChangesNothing") {
  const SmallLevel level;
  level.writeLevel("rays = 64\nlocal_lights = true");
  level.bake("out");
  const auto bytes = [&](const std::string& name) {
    return readBytes(level / ("out/sectors/sector_" + name + ".welkin"));
  };
  const auto first = bytes("-1_0");
  const auto third = bytes("2_0");
  level.writeHut(171.0);
  REQUIRE(level.bake("out", {"--force"}) == kSectors);
  REQUIRE(bytes("-1_0") == first);  // 150 m away; 0_0 and its probes, which light it, see none of the hut.
  REQUIRE(bytes("2_0") != third);
}
