// SPDX-License-Identifier: Apache-2.0
// The files of a baked level: inspect, validate and merge on whole, incomplete and damaged ones.
#include <catch2/catch.hpp>

#include "level_text.h"

using namespace welkin::tests;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

std::string sectorFile(const std::string& name) {
  return "/sectors/sector_" + name + ".welkin";
}

}  // namespace

TEST_CASE("LevelFiles, TheDepfileNamesWhatIsWrittenLast") {
  const SmallLevel level;
  const auto target = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"--depfile", level / "d"};
    words.insert(words.end(), more.begin(), more.end());
    REQUIRE(runTool(level.command("out", words)).status == 0);
    const std::string rule = readBytes(level / "d");
    REQUIRE(rule.find(level / "level.gltf") != std::string::npos);
    return rule.substr(0, rule.find(':'));
  };
  REQUIRE(target({}) == level / "out/level.welkin");
  REQUIRE(target({"--shard", "1/2"}) == level / "out/level.1-of-2.welkin");
}

TEST_CASE("LevelFiles, FoldersAreInspectedAndHalfOnesRefused") {
  const SmallLevel level;
  level.bake("out");
  const json all = json::parse(runTool({"inspect", level / "out", "--json"}).out);
  REQUIRE(all["level"]["sectors"].size() == kSectors);
  REQUIRE(all["sky"]["keys"].size() > 0);
  REQUIRE(runTool({"inspect", level / "out"}).out.find("level, 4 sectors") != std::string::npos);
  REQUIRE(runTool({"validate", level / "level.toml", level / "out"}).status == 0);
  fs::remove(level / "out/level.welkin");
  const Run half = runTool({"validate", level / "out"});
  REQUIRE(half.status == 3);
  REQUIRE(half.said("no level.welkin"));
  std::ofstream(level / "level.gltf") << "{}";
  REQUIRE(runTool({"validate", level / "level.toml"}).status == 3);
}

TEST_CASE("LevelFiles, MergeSaysWhatIsMissingOrAnother") {
  const SmallLevel level;
  const auto merge = [&](int status, const std::string& why) {
    const Run run = runTool({"merge", level / "out"});
    INFO(run.err);
    REQUIRE(run.status == status);
    REQUIRE(run.said(why));
    REQUIRE_FALSE(fs::exists(level / "out/level.welkin"));
  };
  merge(2, level / "out");
  REQUIRE(runTool(level.command("out", {"--shard", "0/2"})).status == 0);
  merge(2, "shard 1/2 is missing");
  level.writeHut(180.0);
  REQUIRE(runTool(level.command("out", {"--shard", "1/2"})).status == 0);
  merge(3, "shards 0/2 and 1/2 were baked of different levels");
  level.writeHut(170.0);
  REQUIRE(runTool(level.command("out", {"--shard", "1/2"})).status == 0);
  const std::string file = level / ("out" + sectorFile("1_0"));
  const std::string whole = readBytes(file);
  fs::remove(file);
  merge(2, "sector_1_0.welkin");
  std::ofstream(file, std::ios::binary) << whole.substr(0, whole.size() / 2);
  merge(3, "sector_1_0.welkin");
  fs::copy_file(level / ("out" + sectorFile("0_0")), file, fs::copy_options::overwrite_existing);
  merge(3, "is not the sector 1_0");
  std::ofstream(file, std::ios::binary) << whole;
  REQUIRE(runTool({"merge", level / "out"}).status == 0);
}

TEST_CASE("LevelFiles, AnEmptyFileIsWrongContent") {
  const SmallLevel level;
  for (const char* shard : {"0/2", "1/2"}) REQUIRE(runTool(level.command("out", {"--shard", shard})).status == 0);
  REQUIRE(runTool({"merge", level / "out"}).status == 0);
  const auto requireContent = [&](const std::string& command, const std::string& file) {
    const Run run = runTool({command, level / "out"});
    INFO(command << ": " << run.err);
    REQUIRE(run.status == 3);
    REQUIRE(run.err.starts_with("welkin: " + level / ("out/" + file)));
    REQUIRE_FALSE(run.said("null pointer"));
  };
  for (const std::string file : {"sky.welkin", "level.welkin", "level.1-of-2.welkin", "sectors/sector_0_0.welkin"}) {
    const std::string path = level / ("out/" + file);
    const std::string whole = readBytes(path);
    fs::resize_file(path, 0);
    if (file != "level.1-of-2.welkin") requireContent("validate", file);
    if (file != "level.welkin") requireContent("merge", file);
    std::ofstream(path, std::ios::binary) << whole;
  }
  REQUIRE(runTool({"validate", level / "out"}).status == 0);
}

TEST_CASE("LevelFiles, DamagedSectorsAreFoundAndBakedAgain") {
  const SmallLevel level;
  level.bake("out");
  level.bake("whole");
  const std::string file = level / ("out" + sectorFile("0_0"));
  std::string bytes = readBytes(file);
  bytes[bytes.size() / 2] ^= 1;
  std::ofstream(file, std::ios::binary) << bytes;
  std::ofstream(level / "out/sectors/sector_7_7.welkin") << "of an older level";
  for (const std::string& path : {file, level / "out"}) {
    const Run run = runTool({"validate", path});
    REQUIRE(run.status == 3);
    REQUIRE(run.said("sector_0_0.welkin"));
    REQUIRE(run.said("damaged"));
  }
  REQUIRE(level.bake("out") == 1);
  requireSame(level.path() / "out", level.path() / "whole");
}

TEST_CASE("LevelFiles, InspectExplainsEveryByte") {
  const SmallLevel level;
  level.bake("out");
  const std::string file = level / ("out" + sectorFile("2_0"));
  const Run run = runTool({"inspect", file, "--json"});
  REQUIRE(run.status == 0);
  const json sector = json::parse(run.out)["sector"];
  REQUIRE(sector["x"] == 2);
  REQUIRE(sector["z"] == 0);
  REQUIRE(sector["grid"].size() == 4096);
  REQUIRE(sector["bounds"][3] == 192.0);
  const json& bytes = sector["bytes"];
  REQUIRE(bytes["total"] == fs::file_size(file));
  int explained = 0;
  for (const char* part : {"probes", "grid", "occlusion", "rooms", "cuts", "local", "settings", "header", "structure"})
    explained += bytes[part].get<int>();
  REQUIRE(explained == bytes["total"].get<int>());
  REQUIRE(bytes["occlusion"] == 256);
  for (const char* tile : {"probe", "sky_visibility", "probe_y"}) REQUIRE(sector["occlusion"][tile].size() == 256);
  for (const json& share : sector["occlusion"]["sky_visibility"]) REQUIRE(share > 0.5);
  REQUIRE((sector["rooms"].empty() && bytes["rooms"] == 0 && sector["unlit"] == 0));
  std::size_t probes = 0;
  for (const auto& [part, count] : bytes.items())
    if (part.rfind("probes_", 0) == 0) probes += count.get<std::size_t>();
  REQUIRE(bytes["probes"] == probes);
  REQUIRE(bytes["probes_sky"] == 48 * sector["probes"].size());
  REQUIRE(bytes["probes_position"] == 6 * sector["probes"].size());
  REQUIRE(bytes["a_probe"] == 104);
  REQUIRE(sector["probes"].size() > 4);
  for (const json& probe : sector["probes"]) {
    REQUIRE(probe["position"][0] >= 128.0);
    REQUIRE(probe["position"][0] <= 192.0);
    REQUIRE(probe["visibility"].size() == 4);
    REQUIRE(probe["transfer"]["g"][3].size() == 4);
  }
  const json index = json::parse(runTool({"inspect", level / "out/level.welkin", "--json"}).out)["level"];
  REQUIRE(index["sectors"].size() == kSectors);
  REQUIRE(index["sectors"][3]["probes"] == sector["probes"].size());
  REQUIRE(runTool({"inspect", file}).status == 0);
}

TEST_CASE("LevelFiles, RoomsAreInTheFileAndOfItsSectorsAlone") {
  const SmallLevel level;
  level.bake("out");
  // A room around the hut's west, in 2_0 and within the reach of 1_0. Its settings change, but its file has no space.
  level.writeLevel("rays = 64", "[[room]]\nbox = [140, -1, 8, 165.5, 8, 56]");
  REQUIRE(level.bake("out") == 2);
  const auto inspected = [&](const std::string& sector) {
    return json::parse(runTool({"inspect", level / ("out" + sectorFile(sector)), "--json"}).out)["sector"];
  };
  const json with = inspected("2_0");
  REQUIRE(with["rooms"].size() == 1);
  REQUIRE(with["rooms"][0]["box"] == std::vector<double>{140, -1, 8, 165.5, 8, 56});
  std::size_t inside = 0;
  for (const json& probe : with["probes"]) {
    const double x = probe["position"][0];
    const double z = probe["position"][2];
    const bool in = x >= 140 && x <= 165.5 && z >= 8 && z <= 56 && probe["position"][1] <= 8.0;
    REQUIRE(probe["room"] == (in ? 1 : 0));
    inside += in ? 1 : 0;
  }
  REQUIRE((inside > 0 && inside < with["probes"].size()));
  REQUIRE(with["probes"][with["rooms"][0]["probe"].get<std::size_t>()]["room"] == 1);
  REQUIRE(with["bytes"]["rooms"] == 28 + with["probes"].size());
  REQUIRE(inspected("1_0")["rooms"].empty());
  REQUIRE(runTool({"validate", level / "out"}).status == 0);
}
