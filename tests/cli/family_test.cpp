// SPDX-License-Identifier: Apache-2.0
// Skies that are baked together share their modes. The report states the error of their blends, and the same files come
// of any order.
#include <catch2/catch.hpp>

#include "baked.h"
#include "level_text.h"

using namespace welkin::tests;
using nlohmann::json;

namespace {

const std::string kOvercast = "luminance = \"cie-2\"\nnormalise = \"zenith\"\nintensity = 0.4";
const std::string kModes = "cubemap_size = 0\nreconstruction = \"modes\"";
const std::vector<std::string> kBudget = {"--max-error", "0.05"};

/// clear.toml and storm.toml, along one path of the sun.
struct TwoSkies {
  TwoSkies() {
    folder.write("clear.toml", skyText(kDay, kDaySun, kModes));
    writeStorm(kOvercast);
  }
  void writeStorm(const std::string& sky, const std::string& sun = kDaySun, const std::string& bake = kModes) const {
    folder.write("storm.toml", skyText(sky, sun, bake));
  }
  Run bake(const std::string& out, std::vector<std::string> files = {"clear.toml", "storm.toml"},
           const std::vector<std::string>& more = kBudget) const {
    std::vector<std::string> words = {"bake"};
    for (const std::string& file : files) words.push_back(folder / file);
    words.insert(words.end(), {"-o", folder / out, "--progress", "none"});
    words.insert(words.end(), more.begin(), more.end());
    return runTool(words);
  }
  json read(const std::string& name) const { return json::parse(readBytes(folder / name)); }
  json familyOf(const std::string& file) const {
    return printedJson({"inspect", folder / file, "--json"})["sky"]["modes"]["family"];
  }

  Folder folder;
};

void requireRefused(const Run& run, const std::vector<std::string>& words) {
  CAPTURE(run.err);
  REQUIRE(run.status == 3);
  for (const std::string& word : words) CHECK(run.err.find(word) != std::string::npos);
}

}  // namespace

TEST_CASE("Family, SkiesShareTheirModesAndTheReportHasTheirBlends") {
  const TwoSkies skies;
  const Run run = skies.bake("out");
  INFO(run.err);
  REQUIRE(run.status == 0);
  CHECK(filesUnder(skies.folder / "out") == std::vector<std::string>{"clear.json", "clear.welkin", "report.json",
                                                                     "storm.json", "storm.welkin", "timing.json"});
  CHECK(run.err.find("clear: irradiance within") != std::string::npos);
  CHECK(run.err.find("blends within") != std::string::npos);
  const json report = skies.read("out/report.json");
  REQUIRE(report["skies"].size() == 2);
  for (const char* name : {"clear", "storm"}) {
    const json& certificate = report["skies"][name]["certificate"];
    CHECK(certificate["max_error"] <= 0.05);
    REQUIRE(certificate["blends"].size() == 1);
    CHECK(certificate["blends"][0] == report["blends"]);
    const json inspected = printedJson({"inspect", skies.folder / ("out/" + std::string(name) + ".welkin"), "--json"});
    CHECK(inspected["sky"]["certificate"]["blends"]["max_error"] == report["blends"]["max_error"]);
  }
  CHECK(report["blends"]["skies"] == json({"clear", "storm"}));
  CHECK(report["blends"]["max_error"] > 0.0);
  CHECK(report["blends"]["max_error"] <= 0.05);
  CHECK(skies.familyOf("out/clear.welkin") == skies.familyOf("out/storm.welkin"));
  CHECK(runTool({"validate", skies.folder / "out"}).status == 0);

  REQUIRE(skies.bake("alone", {"clear.toml"}).status == 0);  // as ever
  CHECK(skies.read("alone/report.json")["certificate"].contains("blends") == false);
  CHECK(skies.familyOf("alone/sky.welkin") != skies.familyOf("out/clear.welkin"));
}

TEST_CASE("Family, SameBytesForAnyOrderAndThreads") {
  const TwoSkies skies;
  REQUIRE(skies.bake("a").status == 0);
  REQUIRE(skies.bake("b", {"storm.toml", "clear.toml"}, {"--max-error", "0.05", "--threads", "1"}).status == 0);
  for (const char* name : {"clear.welkin", "storm.welkin", "clear.json", "storm.json"}) {
    INFO(name);
    CHECK(readBytes(skies.folder / ("a/" + std::string(name))) == readBytes(skies.folder / ("b/" + std::string(name))));
  }
}

TEST_CASE("Family, IsBakedAgainWhenOneOfItChanges") {
  const TwoSkies skies;
  const auto baked = [&] { return skies.read("out/timing.json")["sky_baked"].get<bool>(); };
  const auto plan = [&] {
    return printedJson({"plan", skies.folder / "storm.toml", skies.folder / "clear.toml", "-o", skies.folder / "out",
                        "--max-error", "0.05", "--json"})["skies"];
  };
  REQUIRE(skies.bake("out").status == 0);
  CHECK(baked());
  const std::string report = readBytes(skies.folder / "out/report.json");
  REQUIRE(skies.bake("out").status == 0);
  CHECK(!baked());
  CHECK(readBytes(skies.folder / "out/report.json") == report);
  CHECK(plan()["clear"]["sky"]["why"] == "up to date");
  skies.writeStorm(kOvercast + "5");
  CHECK(plan()["storm"]["sky"]["why"] == "changed: storm.toml");
  CHECK(plan()["clear"]["sky"]["why"] == "changed: family");
  REQUIRE(skies.bake("out").status == 0);
  CHECK(baked());
  flipBit(skies.folder / "out/storm.welkin", 200);
  CHECK(runTool({"validate", skies.folder / "out"}).status == 3);
}

TEST_CASE("Family, ErrorsNameBothFilesAndTheKey") {
  const TwoSkies skies;
  skies.writeStorm(kOvercast, "path = [[0, 0, -40], [6, 90, 0], [12, 180, 50], [18, 270, 0]]");
  requireRefused(skies.bake("out"), {"storm.toml: sun.path is [[0", "clear.toml", "share the sun's path"});
  skies.writeStorm(kOvercast + "\nluminance_unit = 2");
  requireRefused(skies.bake("out"), {"storm.toml: sky.luminance_unit is 2", "clear.toml, absent"});
  skies.writeStorm(kOvercast, kDaySun, kModes + "\nbands = 3");
  requireRefused(skies.bake("out"), {"storm.toml: bake.bands is 3", "clear.toml, absent"});
  skies.writeStorm(kOvercast, kDaySun, kModes + "\nmax_error = 0.1");
  requireRefused(skies.bake("out", {"clear.toml", "storm.toml"}, {}), {"bake.max_error", "all have a budget, or none"});
  skies.folder.write("more/clear.toml", skyText(kDay, kDaySun));
  requireRefused(skies.bake("out", {"clear.toml", "more/clear.toml"}), {"clear.toml and ", "rename one"});
  skies.folder.write("report.toml", skyText(kDay, kDaySun));
  requireRefused(skies.bake("out", {"clear.toml", "report.toml"}), {"report.toml", "report.json", "rename it"});
  const SmallLevel level;
  const Run beside = runTool({"bake", level / "level.toml", skies.folder / "clear.toml", "-o", skies.folder / "out"});
  CHECK(beside.status == 1);
  CHECK(beside.err.find("is a level file and stands beside") != std::string::npos);
  CHECK(!std::filesystem::exists(skies.folder / "out"));
}

TEST_CASE("Family, OfALevelHasItsSkyFirst") {
  const SmallLevel level;
  const auto writeLevel = [&](const std::string& skies) {
    std::string text = readBytes(level / "level.toml");
    const auto at = text.find("sky = "), end = text.find('\n', at);
    std::ofstream(level / "level.toml", std::ios::binary) << text.replace(at, end - at, "sky = " + skies);
  };
  const auto writeStorm = [&](const std::string& sky) {
    std::string text = readBytes(level / "sky.toml");
    std::ofstream(level / "storm.toml", std::ios::binary) << text.insert(text.find("[sky]\n") + 6, sky);
  };
  REQUIRE(level.bake("alone", kBudget) == kSectors);
  writeLevel("[\"sky.toml\"]");
  REQUIRE(level.bake("list", kBudget) == kSectors);
  CHECK(readBytes(level / "list/sky.welkin") == readBytes(level / "alone/sky.welkin"));
  writeStorm("intensity = 0.2\n");
  writeLevel("[\"sky.toml\", \"storm.toml\"]");
  REQUIRE(level.bake("out", kBudget) == kSectors);
  CHECK(std::filesystem::exists(level / "out/storm.welkin"));
  const json report = json::parse(readBytes(level / "out/report.json"));
  CHECK(report["skies"].size() == 2);
  CHECK(report["table"] == report["skies"]["sky"]["table"]);
  CHECK(report["sectors"].size() == kSectors);
  CHECK(runTool({"validate", level / "out"}).status == 0);
  REQUIRE(level.bake("out", kBudget) == 0);  // nothing changed
  for (const std::string shard : {"0/2", "1/2"}) {
    std::vector<std::string> more = {"--shard", shard};
    more.insert(more.end(), kBudget.begin(), kBudget.end());
    REQUIRE(runTool(level.command("shards", more)).status == 0);
  }
  REQUIRE(runTool({"merge", level / "shards"}).status == 0);
  CHECK(readBytes(level / "shards/storm.welkin") == readBytes(level / "out/storm.welkin"));
  CHECK(readBytes(level / "shards/level.welkin") == readBytes(level / "out/level.welkin"));

  writeStorm("ground_albedo = [0.3, 0.3, 0.3]\n");
  requireRefused(runTool(level.command("out", kBudget)),
                 {"storm.toml: sky.ground_albedo is [0.3,0.3,0.3]", "sky.toml, absent"});
  writeLevel("[]");
  requireRefused(runTool(level.command("out", kBudget)), {"level.toml", "sky", "list of one or more names"});
  writeLevel("[\"sky.toml\", 3]");
  requireRefused(runTool(level.command("out", kBudget)), {"level.toml", "sky", "list of one or more names"});
}
