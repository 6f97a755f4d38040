// SPDX-License-Identifier: Apache-2.0
// The bake of a level: which sectors an edit makes stale, and the same bytes by every way of baking.
#include <catch2/catch.hpp>

#include "level_text.h"

using namespace welkin::tests;
using nlohmann::json;
namespace fs = std::filesystem;

TEST_CASE("Level, BakesSectorsAndIndexAndRepeatsNothing") {
  const SmallLevel level;
  REQUIRE(level.bake("out") == kSectors);
  REQUIRE(filesUnder(level.path() / "out") ==
          std::vector<std::string>{"level.welkin", "report.json", "sectors/sector_-1_0.welkin",
                                   "sectors/sector_0_0.welkin", "sectors/sector_1_0.welkin",
                                   "sectors/sector_2_0.welkin", "sky.json", "sky.welkin", "timing.json"});
  const std::string report = readBytes(level / "out/report.json");
  REQUIRE(json::parse(report)["sectors"].size() == kSectors);
  const auto date = fs::last_write_time(level / "out/level.welkin");
  REQUIRE(level.bake("out") == 0);
  REQUIRE(readBytes(level / "out/report.json") == report);
  REQUIRE(fs::last_write_time(level / "out/level.welkin") == date);
  REQUIRE(level.bake("out", {"--force"}) == kSectors);
  REQUIRE(level.bake("out", {"--force", "--sectors", "2_0,-1_0"}) == 2);
  REQUIRE(readBytes(level / "out/report.json") != report);  // of two sectors
  REQUIRE(runTool({"validate", level / "out"}).status == 0);
}

TEST_CASE("Level, AnEditRebakesWhatIsWithinReach") {
  const SmallLevel level;
  level.bake("out");
  level.writeHut(171.0);  // in 2_0, and within 64 m of 1_0
  REQUIRE(level.bake("out") == 2);
  level.writeHut(150.0);
  level.writeLevel("rays = 64\nreach_m = 16");  // settings of all
  REQUIRE(level.bake("out") == kSectors);
  level.writeHut(151.0);  // 23 m from 1_0 now
  REQUIRE(level.bake("out") == 1);
  level.writeLevel("rays = 64\nreach_m = 16", "add = [[-30, 1, 30]]");
  REQUIRE(level.bake("out") == 1);
  level.writeLevel("rays = 64\nreach_m = 16", "add = [[-30, 1, 30]]\n[scale]\nsky = 2");
  REQUIRE(level.bake("out") == 0);  // the index holds the scale
  level.writeSky(60.0, "intensity = 2");
  REQUIRE(level.bake("out") == 0);  // a setting of the sky alone
  level.writeSky(50.0);
  REQUIRE(level.bake("out") == kSectors);  // the sun's path
  level.writeLevel("rays = 64\nreach_m = 16\nsun = \"sh\"");
  REQUIRE(level.bake("out") == kSectors);
  level.writeSky(40.0);
  REQUIRE(level.bake("out") == 0);
  level.writeSky(40.0, "ground_albedo = [0.1, 0.2, 0.3]");
  REQUIRE(level.bake("out") == kSectors);
  REQUIRE(runTool({"validate", level / "out"}).status == 0);
}

TEST_CASE("Level, PlanSaysWhatIsOutOfDateAndWhy") {
  const SmallLevel level;
  const auto plan = [&] {
    const Run run = runTool({"plan", level / "level.toml", "-o", level / "out", "--json"});
    INFO(run.err);
    REQUIRE(run.status == 0);
    return json::parse(run.out)["sectors"];
  };
  const json before = plan();
  REQUIRE(before.size() == kSectors);
  for (const json& sector : before) REQUIRE(sector["why"] == "missing");
  level.bake("out");
  const json after = plan();
  for (std::size_t i = 0; i < kSectors; ++i) {
    REQUIRE(after[i]["bake"] == false);
    REQUIRE(after[i]["probes"] == before[i]["probes"]);
    const double bytes = after[i]["bytes"];
    REQUIRE(before[i]["bytes"].get<double>() == Approx(bytes).epsilon(0.2));
  }
  level.writeHut(171.0);
  const json edited = plan();
  REQUIRE(edited[0]["why"] == "up to date");
  REQUIRE(edited[1]["why"] == "up to date");
  REQUIRE(edited[2]["why"] == "changed: geometry or textures within reach");
  REQUIRE(edited[3]["bake"] == true);
  level.writeSky(50.0);
  REQUIRE(plan()[0]["why"] == "changed: light paths");
  const auto total = [](const json& sectors, const char* key) {
    std::uint64_t sum = 0;
    for (const json& sector : sectors) sum += sector[key].get<std::uint64_t>();
    return sum;
  };
  const auto traced = json::parse(readBytes(level / "out/timing.json"))["rays"].get<std::uint64_t>();
  REQUIRE(traced > 0);
  REQUIRE(traced <= total(before, "most_rays"));
  REQUIRE(total(after, "most_rays") == 0);
  const Run text = runTool({"plan", level / "level.toml"});
  REQUIRE(text.status == 0);
  REQUIRE_THAT(text.out, Catch::Contains("; at most " + std::to_string(total(plan(), "most_rays")) + " rays\n"));
}

TEST_CASE("Level, SameBytesForAnyThreadsShardsAndOrder") {
  const SmallLevel level;
  level.bake("one", {"--threads", "1"});
  level.bake("all");
  requireSame(level.path() / "one", level.path() / "all");
  REQUIRE(readBytes(level / "one/report.json") == readBytes(level / "all/report.json"));
  for (const char* shard : {"2/3", "0/3", "1/3"})
    REQUIRE(runTool(level.command("shards", {"--shard", shard})).status == 0);
  REQUIRE_FALSE(fs::exists(level / "shards/level.welkin"));
  const Run merged = runTool({"merge", level / "shards"});
  REQUIRE(merged.status == 0);
  REQUIRE(merged.out == level / "shards/level.welkin" + ": 4 sectors\n");
  requireSame(level.path() / "one", level.path() / "shards");
  for (const char* folder : {"/one", "/shards"})
    REQUIRE(json::parse(readBytes(level.path().string() + folder + "/timing.json"))["level"] == "../level.toml");
  REQUIRE(readBytes(level / "one/report.json") == readBytes(level / "shards/report.json"));
  for (const char* sector : {"1_0", "2_0", "-1_0", "0_0"}) level.bake("named", {"--sectors", sector});
  requireSame(level.path() / "one", level.path() / "named");
  REQUIRE(runTool({"merge", level / "shards"}).status == 0);  // again
  REQUIRE(level.bake("shards") == 0);
  REQUIRE(filesUnder(level.path() / "shards").size() == kSectors + 3 + 2 + 6);  // No parts, but the shards' reports.
}

TEST_CASE("Level, CommandLinesThatAreWrong") {
  const SmallLevel level;
  for (const std::string shard : {"2/2", "-1/2", "1", "1/", "/2", "0/0", "a/b", "0/2x"}) {
    const Run run = runTool(level.command("out", {"--shard=" + shard}));
    INFO(shard << run.err);
    REQUIRE(run.status == 1);
    REQUIRE(run.said("0 <= i < n"));
  }
  for (const std::string sectors : {"9_9", "0", "0_0,", "0_0;1_0"})
    REQUIRE(runTool(level.command("out", {"--sectors=" + sectors})).status == 1);
  for (const std::string word : {"--shard=0/1", "--sectors=0_0"}) {
    const Run run = runTool({"bake", level / "sky.toml", "-o", level / "out", word});
    REQUIRE(run.status == 1);
    REQUIRE(run.said("is no level file"));
  }
  level.writeLevel("rays = \"auto\"");
  const Run run = runTool(level.command("out"));
  REQUIRE(run.status == 3);
  REQUIRE(run.said("--max-error"));
  REQUIRE_FALSE(fs::exists(level / "out"));
}

TEST_CASE("Level, PlanDrawsWhereProbesAre") {
  const SmallLevel level;
  REQUIRE(runTool({"plan", level / "level.toml", "--pictures", level / "pictures", "--progress", "none"}).status == 0);
  REQUIRE(filesUnder(level.path() / "pictures") == std::vector<std::string>{"placement.png", "section.png"});
  for (const char* name : {"pictures/placement.png", "pictures/section.png"})
    REQUIRE(readBytes(level / name).substr(1, 3) == "PNG");
  const Run sky = runTool({"plan", level / "sky.toml", "--pictures", level / "others", "--progress", "none"});
  REQUIRE(sky.status == 1);
  REQUIRE(sky.said("needs a level.toml"));
}

TEST_CASE("Level, SectorsThatMissTheBudgetAreNamed") {
  const SmallLevel level;
  level.writeLevel("rays = \"auto\"");
  const auto hard = [&](const std::string& budget) {
    level.bake("out", {"--max-error", budget, "--force", "--sectors", "2_0"});
    const json report = json::parse(readBytes(level / "out/report.json"));
    std::size_t named = 0;
    for (const auto& warning : report["warnings"])
      if (warning["id"] == "hard-sector") {
        REQUIRE(warning["message"].get<std::string>().find("sector 2_0") != std::string::npos);
        ++named;
      }
    const auto& error = report["sectors"][0]["error"];
    const double most = std::stod(budget);
    const auto& encoding = error["encoding"];
    const double sun = std::hypot(error["modes"]["worst_row"].get<double>(), encoding["sun"].get<double>());
    const double total = std::hypot(error["sampling"].get<double>(), std::max(encoding["sky"].get<double>(), sun));
    REQUIRE(error["total"].get<double>() == Approx(total).epsilon(1e-12));
    REQUIRE(named == std::size_t{total > most});
    REQUIRE(report["sectors"][0]["rays"] > 0);
    return named;
  };
  REQUIRE(hard("0.2") == 0);
  REQUIRE(hard("0.001") > 0);
}
