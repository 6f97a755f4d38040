// SPDX-License-Identifier: Apache-2.0
// Warnings: the bake succeeds, and each warning is printed and counted.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "run_tool.h"
#include "sky_text.h"

using namespace welkin::tests;
using nlohmann::json;

namespace {

const std::string kThreeKeys = "path = [[6, 90, 0], [12, 180, 60], [18, 270, 0]]";
const std::string kGoodPath = "path = [[0, 0, -60], [6, 90, 0], [12, 180, 60], [18, 270, 0]]";
const std::string kNeverRises = "path = [[0, 0, -60], [12, 180, -5.2]]";

/// Output of bake and plan for a sun and other sections.
struct Said {
  json report, plan;
  std::string err;
};

Said say(const std::string& sun) {
  const Folder folder;
  const std::string sky = folder.write("my.toml", skyText(kUniform, sun));
  const Run baked = runTool({"bake", sky, "-o", folder / "out", "--progress", "none", "--certify", "none"});
  INFO(baked.err);
  REQUIRE(baked.status == 0);
  const Run planned = runTool({"plan", sky, "--json"});
  REQUIRE(planned.status == 0);
  REQUIRE(planned.err == baked.err);
  const Run valid = runTool({"validate", sky, folder / "out"});
  REQUIRE(valid.status == 0);
  REQUIRE(valid.err == baked.err);
  return {json::parse(readBytes(folder / "out/report.json")), json::parse(planned.out), baked.err};
}

}  // namespace

TEST_CASE("Warnings, ThreeKeysLeaveTheSunOnTheHorizon") {
  const Said said = say(kThreeKeys);
  const json warnings = said.report["warnings"];
  REQUIRE(warnings.size() == 1);
  REQUIRE(warnings[0]["id"] == "sun-on-horizon");
  REQUIRE(warnings[0]["count"] == 1);
  REQUIRE(warnings[0]["message"] ==
          "my.toml:5: sun.path: the sun lies on the horizon from 18 h to 6 h (12 hours); if it should set, add a key "
          "below the horizon, for example [0, 0, -30]");
  REQUIRE(said.plan["warnings"] == warnings);
  REQUIRE(said.err == "welkin: warning: " + warnings[0]["message"].get<std::string>() + "\n");
}

TEST_CASE("Warnings, MoonsPathIsCheckedToo") {
  const Said said = say(kGoodPath + "\n[moon]\n" + kThreeKeys);
  REQUIRE(said.report["warnings"].size() == 1);
  REQUIRE(said.report["warnings"][0]["id"] == "moon-on-horizon");
  REQUIRE(said.err.find("my.toml:7: moon.path: the moon lies on the horizon") != std::string::npos);
  REQUIRE(say(kThreeKeys + "\n[moon]\n" + kThreeKeys).report["warnings"].size() == 2);
}

TEST_CASE("Warnings, SunThatNeverRisesBakes") {
  const Said said = say(kNeverRises);
  REQUIRE(said.report["warnings"].size() == 1);
  REQUIRE(said.report["warnings"][0]["id"] == "sun-never-rises");
  REQUIRE(said.err.find("5.2 degrees below the horizon") != std::string::npos);
  REQUIRE(said.plan["sun_path"]["highest_deg"].get<double>() == Approx(-5.2));
  REQUIRE(said.plan["sun_path"]["highest_time_h"] == 12.0);
  REQUIRE(say(kGoodPath + "\n[moon]\n" + kNeverRises).report["warnings"][0]["id"] == "moon-never-rises");
}

TEST_CASE("Warnings, PolarNightIsAFactAndNoWarning") {
  const std::string night = "latitude_deg = 78\nday_of_year = 355";
  const Said said = say(night);
  REQUIRE(said.err.empty());
  REQUIRE(said.report["warnings"].empty());
  REQUIRE(said.plan["sun_path"]["highest_deg"].get<double>() == Approx(12.0 - 23.44).margin(0.05));
  REQUIRE(said.plan["moon_path"].is_null());
  const Folder folder;
  const Run plan = runTool({"plan", folder.write("my.toml", skyText(kUniform, night))});
  REQUIRE(plan.out.find("\nsun        never rises: highest at ") != std::string::npos);
}

TEST_CASE("Warnings, NoneOfGoodSkies") {
  REQUIRE(say(kGoodPath).err.empty());
  REQUIRE(say(kGoodPath + "\n[moon]\ndeclination_deg = -20\nphase = 0.5\nlatitude_deg = 10").plan["warnings"].empty());
  const Folder folder;
  REQUIRE(runTool({"init", folder / "level"}).status == 0);
  for (const std::string& sky : {folder / "level/sky.toml", WELKIN_ISLAND + std::string("/sky.toml")}) {
    INFO(sky);
    const Run plan = runTool({"plan", sky, "--json"});
    REQUIRE(plan.status == 0);
    REQUIRE(plan.err.empty());
    REQUIRE(json::parse(plan.out)["warnings"].empty());
  }
}
