// SPDX-License-Identifier: Apache-2.0
// The levels of examples/talk: what they show holds by probes and by the path tracer.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "run_tool.h"

using namespace welkin::tests;
using nlohmann::json;

namespace {

const std::string kTalk = WELKIN_ROOT "/examples/talk";

/// A baked level of the talk, and the light at some of its points.
class TalkScene {
 public:
  explicit TalkScene(const std::string& level, const std::string& points) : level_(kTalk + "/" + level) {
    const Run run = runTool({"bake", level_, "-o", folder_ / "out", "--quality", "draft", "--progress", "none"});
    INFO(run.err);
    REQUIRE(run.status == 0);
    std::ofstream(folder_ / "points.csv") << points;
  }

  /// The light of every point by `sample` and by `reference`.
  std::vector<json> at(const std::string& time, const std::vector<std::string>& more = {}) const {
    std::vector<json> both(2);
    for (std::size_t i = 0; i < 2; ++i) {
      std::vector<std::string> arguments = {i == 0 ? "sample" : "reference",
                                            i == 0 ? folder_ / "out" : level_,
                                            "--time",
                                            time,
                                            "--points",
                                            folder_ / "points.csv",
                                            "--json"};
      if (i == 1) arguments.insert(arguments.end(), {"--samples", "4096", "--progress", "none"});
      arguments.insert(arguments.end(), more.begin(), more.end());
      const Run run = runTool(arguments);
      INFO(run.err);
      REQUIRE(run.status == 0);
      both[i] = json::parse(run.out)["points"];
    }
    return both;
  }

 private:
  Folder folder_;
  std::string level_;
};

double part(const json& point, const char* component, std::size_t channel) {
  return point["components"][component][channel];
}

double luminance(const json& point, const char* component) {
  return 0.2126 * part(point, component, 0) + 0.7152 * part(point, component, 1) + 0.0722 * part(point, component, 2);
}

}  // namespace

TEST_CASE("Talk, TheWallThatTheSunLightsColoursWhatFacesIt") {
  // Between the walls, towards the red one in the west and the green one in the east.
  const TalkScene walls("walls/level.toml", "32,1.2,36,-1,0,0\n32,1.2,36,1,0,0\n");
  const std::vector<json> morning = walls.at("9");  // the sun stands in the east
  for (const json& light : morning) {
    CHECK(part(light[0], "sun_bounce", 0) > 1.5 * part(light[0], "sun_bounce", 1));
    CHECK(luminance(light[0], "sun_bounce") > 3.0 * luminance(light[1], "sun_bounce"));
  }
  const std::vector<json> afternoon = walls.at("15");
  for (const json& light : afternoon) {
    CHECK(part(light[1], "sun_bounce", 1) > 1.2 * part(light[1], "sun_bounce", 0));
    CHECK(luminance(light[1], "sun_bounce") > 3.0 * luminance(light[0], "sun_bounce"));
  }
}

TEST_CASE("Talk, NightIsDarkerAndBluerThanDayByItsOwnMoon") {
  // On the porch, and under the roof from below.
  const TalkScene yard("yard/level.toml", "32,0,30.5,0,1,0\n32,1.2,30,0,-1,0\n");
  const auto day = yard.at("12");
  const auto night = yard.at("0");
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t p = 0; p < 2; ++p) {
      const auto blueness = [&](const json& light, const char* component) {
        return part(light[p], component, 2) / part(light[p], component, 0);
      };
      CHECK(luminance(night[i][p], "sky") > 0.0);
      CHECK(luminance(day[i][p], "sky") > 50.0 * luminance(night[i][p], "sky"));
      CHECK(luminance(night[i][p], "sun_bounce") > 0.0);
      CHECK(luminance(day[i][p], "sun_bounce") > 50.0 * luminance(night[i][p], "sun_bounce"));
      CHECK(blueness(night[i], "sun_bounce") > 1.5 * blueness(day[i], "sun_bounce"));
    }
}

TEST_CASE("Talk, LocalTransferAloneLightsWhatTheLampDoesNotSee") {
  // East of the wall, towards the north wall that the lamp lights.
  const std::string points = "33,1,30,0,0,-1\n33,1.5,26,0,0,-1\n";
  const std::vector<std::string> lamp = {"--light", "29,2.5,32,20,14,7"};
  const TalkScene with("lamp/level.toml", points);
  const auto lit = with.at("0", lamp);
  for (const json& light : lit)
    for (const json& point : light) {
      CHECK(luminance(point, "local") > 0.005);
      CHECK(part(point, "local", 0) > 2.0 * part(point, "local", 2));  // the lamp is warm
      CHECK(luminance(point, "sun_bounce") == 0.0);
    }
  // A place near the wall is right to a quarter. Deeper in the shadow a lamp's share reaches lights behind the wall, as
  // `sample` tests no sight.
  CHECK(luminance(lit[0][1], "local") == Approx(luminance(lit[1][1], "local")).epsilon(0.25));
  const std::vector<json> no_lamp = with.at("0");
  const std::vector<json> no_transfer = TalkScene("lamp/without.toml", points).at("0", lamp);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(luminance(no_lamp[0][i], "local") == 0.0);
    CHECK(luminance(no_transfer[0][i], "local") == 0.0);
  }
}

TEST_CASE("Talk, TheLampDoesNotShineThroughTheWallThatStandsAlone") {
  // The view is of the side that the lamp does not see. As places beside it have much the same sky, the wall was none
  // for cuts, and light was 2.8 times the tracer's. Without local transfer the rms is 0.8; the tracer's noise is taken
  // off.
  const Folder folder;
  const std::string level = kTalk + "/lamp/level.toml";
  const Run bake = runTool({"bake", level, "-o", folder / "out", "--quality", "draft", "--progress", "none"});
  INFO(bake.err);
  REQUIRE(bake.status == 0);
  const Run run = runTool({"render",
                           folder / "out",
                           "--level",
                           level,
                           "--time",
                           "0",
                           "--size",
                           "96x54",
                           "--paths",
                           "64",
                           "--component",
                           "ambient",
                           "--camera=37,3.5,44",
                           "--yaw",
                           "-12",
                           "--pitch",
                           "-6",
                           "--fov",
                           "50",
                           "--light",
                           "29,2.5,32,20,14,7",
                           "--difference",
                           "--json",
                           "--progress",
                           "none",
                           "-o",
                           folder / "difference.png"});
  INFO(run.err);
  REQUIRE(run.status == 0);
  const json error = json::parse(run.out)["pictures"][0]["error"];
  for (const char* way : {"probes", "query"}) {
    INFO(way);
    CHECK(std::abs(error[way]["mean"].get<double>()) < 0.3);
    CHECK(error[way]["rms"].get<double>() < 0.75);
  }
}
