// SPDX-License-Identifier: Apache-2.0
// welkin sample on a baked level, beside welkin reference at the same points, and files of points.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "level_text.h"

using namespace welkin::tests;
using nlohmann::json;

namespace {

json valueOf(const std::vector<std::string>& arguments) {
  const Run run = runTool(arguments);
  INFO(run.err);
  REQUIRE(run.status == 0);
  return json::parse(run.out);
}

void writePoints(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

void addUp(const json& light) {
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0.0;
    for (const char* part : {"sky", "sun_bounce", "local"}) sum += double{light["components"][part][c]};
    CHECK(double{light["irradiance"][c]} == Approx(sum).epsilon(1e-5));
  }
}

}  // namespace

TEST_CASE("SampleLevel, OpenGroundIsThatOfTheReference") {
  const SmallLevel level(1024);
  level.bake("out");
  // Open ground, up and at the side; the middle of the level; a place beyond all sectors.
  const std::string points = level / "points.csv";
  writePoints(points, "20,0,32,0,2,0\n20,1.5,32,1,0,0\r\n\n64,0,32,0,1,0\n-4000,0,32,0,1,0\n");
  const json baked = valueOf({"sample", level / "out", "--time", "9", "--points", points, "--json"})["points"];
  const json traced = valueOf({"reference", level / "level.toml", "--time", "9", "--points", points, "--samples",
                               "16384", "--progress", "none", "--json"})["points"];
  REQUIRE((baked.size() == 4 && traced.size() == 4));
  CHECK(baked[3].is_null());
  CHECK(!traced[3].is_null());
  for (std::size_t i = 0; i < 3; ++i) {
    addUp(baked[i]);
    for (std::size_t c = 0; c < 3; ++c) {
      const double want = traced[i]["irradiance"][c], got = baked[i]["irradiance"][c];
      // A uniform sky over flat ground is linear in the normal, but for the bands of the sky's bounce: see
      // docs/probes.md.
      CHECK(std::abs(got - want) < 0.06 * want + 4.0 * double{traced[i]["standard_error"][c]});
    }
  }
  // One point alone has the light that it has in the file.
  const json alone =
      valueOf({"sample", level / "out", "--time", "9", "--position", "64,0,32", "--normal", "0,1,0", "--json"});
  CHECK(alone == baked[2]);
  const Run text = runTool({"sample", level / "out", "--time", "9", "--position", "-4000,0,32", "--normal", "0,1,0"});
  CHECK(text.out == "no probe serves this point\n");
}

TEST_CASE("SampleLevel, PointsOfAReferenceDrawPathsOfTheirOwn") {
  const SmallLevel level;
  const std::string points = level / "points.csv";
  writePoints(points, "165,1.5,30,1,0,0\n165,1.5,30,1,0,0\n");
  const json traced = valueOf({"reference", level / "level.toml", "--time", "9", "--points", points, "--samples", "64",
                               "--progress", "none", "--json"})["points"];
  CHECK(traced[0] != traced[1]);
  const json alone = valueOf({"reference", level / "level.toml", "--time", "9", "--position", "165,1.5,30", "--normal",
                              "1,0,0", "--samples", "64", "--progress", "none", "--json"});
  CHECK(traced[0]["irradiance"] == alone["irradiance"]);
}

TEST_CASE("SampleLevel, RefusalsNameFileLineAndRule") {
  const SmallLevel level;
  level.bake("out");
  const auto refused = [&](const std::vector<std::string>& more, int status, const std::string& why) {
    std::vector<std::string> arguments = {"sample", level / "out", "--time", "9"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Run run = runTool(arguments);
    INFO(run.err);
    CHECK(run.status == status);
    CHECK(run.said(why));
    CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
    CHECK(run.out.empty());
  };
  const std::string points = level / "points.csv";
  refused({"--points", points}, 2, "points.csv");
  for (const auto& [text, why] : {std::pair("1,2,3\n", "points.csv:1: \"1,2,3\" is not a point"),
                                  {"0,0,0,0,1,0\n1,2,x,0,1,0\n", "points.csv:2: "},
                                  {"0,0,0,0,0,0\n", "has no normal"},
                                  {"0,0,nan,0,1,0\n", "is not a point"},
                                  {"0,0,0,0,1,0,7\n", "is not a point"},
                                  {"x,y,z,nx,ny,nz\n", "points.csv:1: "},
                                  {"\n\n", "no points"},
                                  {"", "no points"}}) {
    writePoints(points, text);
    refused({"--points", points}, 3, why);
  }
  writePoints(points, "0,0,0,0,1,0\n");
  refused({"--points", points, "--position", "0,0,0"}, 1, "one or the other");
  refused({"--position", "0,0,0"}, 1, "--normal is missing");
  const Run sky =
      runTool({"sample", level / "out/sky.welkin", "--time", "9", "--position", "0,0,0", "--normal", "0,1,0"});
  CHECK(sky.status == 1);
  CHECK(sky.said("level.welkin"));
  // A sector of another bake beside the index.
  level.writeHut(100.0);
  level.bake("other");
  std::filesystem::copy_file(level / "other/sectors/sector_1_0.welkin", level / "out/sectors/sector_1_0.welkin",
                             std::filesystem::copy_options::overwrite_existing);
  refused({"--position", "64,0,32", "--normal", "0,1,0"}, 3, "sector_1_0.welkin: sector (1, 0) is not the file");
}
