// SPDX-License-Identifier: Apache-2.0
// The bake of a level's local transfer: which sectors get it, and the same bytes by any way to them.
#include <catch2/catch.hpp>

#include "level_text.h"

using namespace welkin::test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

json sectorOf(const SmallLevel& level, const std::string& out, const std::string& name) {
  const Run run = runTool({"inspect", level / (out + "/sectors/sector_" + name + ".welkin"), "--json"});
  INFO(run.err);
  REQUIRE(run.status == 0);
  return json::parse(run.out)["sector"];
}

/// Sectors with local transfer, by the bytes that inspect and the report say.
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
  REQUIRE(transfers > sector["probes"].size());  // of neighbours too
  const json& local = sector["error"]["local"];
  REQUIRE(local["kept"] == transfers);
  REQUIRE(local["dropped"] == 0);
  REQUIRE(local["sampling"] > 0.0);
  REQUIRE(local["sampling"] < 0.5);
  const json& bytes = sector["bytes"];
  REQUIRE(bytes["local"] == sector["probes"].size() + 12 * lights + 28 * transfers);
  // Those of sector 1_0 are among them, and nothing of 0_0.
  double least_x = 1e9;
  for (const json& light : sector["virtual_lights"]) least_x = std::min(least_x, light[0].get<double>());
  REQUIRE(least_x >= 64.0);
  REQUIRE(least_x < 128.0);
  std::size_t explained = 0;
  for (const char* part : {"probes", "grid", "occlusion", "rooms", "local", "settings", "header", "structure"})
    explained += bytes[part].get<std::size_t>();
  REQUIRE(explained == bytes["total"]);
  REQUIRE(bytes["structure"] < 2048);
  const json sectors = json::parse(plan.out)["sectors"];
  for (const json& planned : sectors) {
    REQUIRE(planned["local"] == true);
    if (planned["sector"] == "2_0") REQUIRE(planned["bytes"] >= bytes["total"]);
  }
  const Run text = runTool({"inspect", level / "out/sectors/sector_2_0.welkin"});
  REQUIRE(text.out.find(std::to_string(transfers) + " transfers") != std::string::npos);
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
  const auto first = bytes("0_0");
  const auto third = bytes("2_0");
  level.writeHut(171.0);
  REQUIRE(level.bake("out", {"--force"}) == kSectors);
  REQUIRE(bytes("0_0") == first);  // 104 m off, though 1_0, whose probes light it, sees the hut
  REQUIRE(bytes("2_0") != third);
}
