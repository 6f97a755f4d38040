// SPDX-License-Identifier: Apache-2.0
// The bake's sections of level.toml: their values, every number at the ends of its range, and messages about errors.
#include "probes/build/bake_section.h"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "probes/geometry/sector_name.h"
#include "probes/level/level_domain.h"
#include "sky/base/error.h"
#include "tests/folder.h"

namespace welkin::tests {
namespace {
using base::Kind;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

build::BakeSection sectionOf(const std::string& text) {
  const Folder folder;
  return build::bakeSectionOf(base::readToml(folder.write("level.toml", text)));
}

void checkSectionRefused(const std::string& text, const std::string& says) {
  INFO(text);
  try {
    sectionOf(text);
    FAIL("it was read");
  } catch (const base::Error& e) {
    CHECK(e.status() == base::ExitStatus::content);
    CHECK_THAT(e.what(), Catch::Contains("level.toml:") && Catch::Contains(says));
  }
}

bool isOfTheBake(const base::Parameter& p) {
  return p.section == "probes" || p.section == "transfer" || p.section == "scale";
}

/// A file in which only this key is set.
std::string fileOf(const base::Parameter& p, double value) {
  const std::string number = p.kind == Kind::whole_number && std::isfinite(value) ? fmt::format("{:.0f}", value)
                             : std::isnan(value)                                  ? "nan"
                             : std::isinf(value)                                  ? (value < 0.0 ? "-inf" : "inf")
                                                                                  : fmt::format("{:.17e}", value);
  const std::string list = p.kind == Kind::points  ? fmt::format("[[0, {}, 0]]", number)
                           : p.kind == Kind::boxes ? fmt::format("[[-2e6, {}, 0, 1, 2e6, 1]]", number)
                                                   : number;
  return fmt::format("[{}]\n{} = {}\n", p.section, p.key, list);
}

}  // namespace

TEST_CASE("BakeSection, AbsentIsTheDesignsDefault") {
  const build::BakeSection s = sectionOf("[level]\nsky = \"sky.toml\"\n");
  CHECK(s.probes.spacing_m == 4.0);
  CHECK(s.probes.vegetation_spacing_m == 8.0);
  CHECK(s.probes.minimum_separation_m == 7.0);
  CHECK(s.probes.height_m == 1.0);
  const placement::PlacementSettings of_placement;
  CHECK(s.probes.headroom_m == of_placement.headroom_m);
  CHECK(s.probes.clearance_m == of_placement.clearance_m);
  CHECK(s.probes.coverage_m == of_placement.coverage_m);
  CHECK(s.probes.walls == of_placement.walls);
  CHECK((s.probes.add.empty() && s.probes.remove.empty() && s.probes.room.empty()));
  CHECK(s.transfer.rays == 1024);
  CHECK(s.transfer.bounces == 2);
  CHECK(s.transfer.sun == transfer::SunTransfer::directional);
  CHECK(s.transfer.local_lights.where == build::LocalLights::Where::near_lights);
  CHECK(s.transfer.reach_m == 128.0);
  CHECK(s.scale.sun_bounce == 1.0);
  CHECK(s.scale.sky == 1.0);
}

TEST_CASE("BakeSection, GivesWhatTheFileSays") {
  const build::BakeSection s = sectionOf(R"(
[probes]
spacing_m = 2
vegetation_spacing_m = 6.5
minimum_separation_m = 0
height_m = 1.5
headroom_m = 2
clearance_m = 0.5
coverage_m = 10
walls = "ignore"
add = [[1, 2, 3], [-4.5, 5, 6]]
remove = [[-1, -2, -3, 1, 2, 3]]
within = [[-64, 0, -64, 64, 1, 64], [70, 0, 0, 71, 1, 1]]
[[room]]
box = [0, 1, 2, 3, 4, 5]
[[room]]
box = [10, 11, 12, 13, 14, 15]
doors = [[11, 11, 14, 12, 13, 16], [9, 11, 12.5, 11, 13, 14]]
[transfer]
rays = "auto"
bounces = 0
sun = "sh"
local_lights = ["3_-4", "-1_0"]
reach_m = 1
[scale]
sun_bounce = 0
sky = 2.5
)");
  CHECK(s.probes.spacing_m == 2.0);
  CHECK(s.probes.vegetation_spacing_m == 6.5);
  CHECK(s.probes.minimum_separation_m == 0.0);
  CHECK(s.probes.height_m == 1.5);
  CHECK(s.probes.headroom_m == 2.0);
  CHECK(s.probes.clearance_m == 0.5);
  CHECK(s.probes.coverage_m == 10.0);
  CHECK(s.probes.walls == placement::Walls::ignore);
  REQUIRE(s.probes.add.size() == 2);
  CHECK(s.probes.add[1] == f64::Number3(-4.5, 5, 6));
  REQUIRE(s.probes.remove.size() == 1);
  CHECK(s.probes.remove[0].low == f64::Number3(-1, -2, -3));
  CHECK(s.probes.remove[0].high == f64::Number3(1, 2, 3));
  REQUIRE(s.probes.within.size() == 2);
  CHECK(s.probes.within[1].high == f64::Number3(71, 1, 1));
  REQUIRE(s.probes.room.size() == 2);
  CHECK(s.probes.room[1].low == f64::Number3(10, 11, 12));
  CHECK(s.probes.room[1].high == f64::Number3(13, 14, 15));
  REQUIRE(s.probes.door.size() == 2);
  CHECK(s.probes.door[1].room == s.probes.room[1]);
  CHECK(s.probes.door[1].box.low == f64::Number3(9, 11, 12.5));
  CHECK_FALSE(s.transfer.rays);
  CHECK(s.transfer.bounces == 0);
  CHECK(s.transfer.sun == transfer::SunTransfer::sh);
  CHECK(s.transfer.local_lights.where == build::LocalLights::Where::listed);
  CHECK(s.transfer.local_lights.sector == std::vector<geometry::SectorId>{{-1, 0}, {3, -4}});
  CHECK(s.transfer.reach_m == 1.0);
  CHECK(s.scale.sun_bounce == 0.0);
  CHECK(s.scale.sky == 2.5);
  CHECK(sectionOf("[transfer]\nlocal_lights = true").transfer.local_lights.where ==
        build::LocalLights::Where::everywhere);
  CHECK(sectionOf("[transfer]\nlocal_lights = false").transfer.local_lights.where ==
        build::LocalLights::Where::nowhere);
  const auto json = nlohmann::json::parse(build::settingsText(s));
  CHECK(json["probes"]["add"][1] == std::vector<double>{-4.5, 5, 6});
  CHECK(json["doors"][0] == std::vector<double>{11, 11, 14, 12, 13, 16});
  CHECK(json["rooms_of_doors"][0] == json["room"][1]);
  CHECK_FALSE(nlohmann::json::parse(build::settingsText(sectionOf(""))).contains("doors"));
  CHECK(json["room"][1] == std::vector<double>{10, 11, 12, 13, 14, 15});
  CHECK(json["transfer"]["local_lights"] == std::vector<std::string>{"-1_0", "3_-4"});
  CHECK(json["transfer"]["rays"] == "auto");
}

TEST_CASE("BakeSection, EveryNumberAtTheEndsOfItsRange") {
  for (const base::Parameter& p : level::levelDomain()) {
    if (!isOfTheBake(p) || p.range.low == p.range.high) continue;
    const double step = p.kind == Kind::whole_number ? 8.0 : 0.0;
    const auto beyond = [&](double value, double towards) {
      return step > 0.0 ? value + std::copysign(step, towards) : std::nextafter(value, towards);
    };
    for (const double inside : {p.range.low, p.range.high}) {
      INFO(fileOf(p, inside));
      if (p.kind != Kind::boxes) CHECK_NOTHROW(sectionOf(fileOf(p, inside)));
    }
    for (const double outside :
         {beyond(p.range.low, -kInfinity), beyond(p.range.high, kInfinity), -kInfinity, kInfinity, std::nan("")})
      checkSectionRefused(fileOf(p, outside), fmt::format("{}.{} = ", p.section, p.key));
  }
}

TEST_CASE("BakeSection, MessagesNameTheKeyAndWhatIsAllowed") {
  checkSectionRefused("[probes]\nspacing = 4", "nearest known one is \"spacing_m\"");
  checkSectionRefused("[transfer]\nbounce = 4", "nearest known one is \"bounces\"");
  checkSectionRefused("[scale]\nsky_bounce = 4", "unknown key");
  checkSectionRefused("[[room]]\nbox = [0, 0, 0, 1, 1, 1]\nname = \"hut\"", "room[0].name");
  checkSectionRefused("[probes]\nadd = [1, 2, 3]", "[x, y, z]");
  checkSectionRefused("[probes]\nadd = [[1, 2]]", "[x, y, z]");
  checkSectionRefused("[probes]\nadd = [[1, 2, \"3\"]]", "must be a number");
  checkSectionRefused("[probes]\nremove = [[0, 0, 0, 1, 0, 1]]", "below its greatest");
  checkSectionRefused("[probes]\nremove = 1", "must be a list");
  checkSectionRefused("[[room]]\nbox = [1, 0, 0, 0, 1, 1]", "room[0].box");
  const std::string room = "[[room]]\nbox = [0, 0, 0, 10, 3, 8]\ndoors = ";
  checkSectionRefused(room + "[4, 0, 7, 6, 2, 9]", "room[0].doors");
  checkSectionRefused(room + "[[4, 0, 7, 6, 2]]", "[min_x, min_y, min_z, max_x, max_y, max_z]");
  checkSectionRefused(room + "[[4, 0, 7, 6, 2, inf]]", "room[0].doors");
  checkSectionRefused(room + "[[4, 0, 7, 3, 2, 9]]", "below its greatest");
  checkSectionRefused(room + "[[4, 0, 7, 6, 2, 9], [4, 0, 7, 6, 2, 8]]",
                      "[4, 0, 7, 6, 2, 8] must cross one upright face");
  checkSectionRefused(room + "[[4, 0, 7, 6, 2, 8.04]]", "by 0.05 m or more on each side");
  checkSectionRefused(room + "[[4, 0, -1, 6, 2, 9]]", "must cross one upright face");
  checkSectionRefused("[room]\nbox = [0, 0, 0, 1, 1, 1]", "[[room]]");
  checkSectionRefused("[transfer]\nrays = \"many\"", "whole number");
  checkSectionRefused("[transfer]\nreach_m = 0.5", "reach_m = 0.5");
  checkSectionRefused("[transfer]\nrays = 1028", "multiple of 8");
  checkSectionRefused("[transfer]\nrays = 1024.0", "whole number");
  checkSectionRefused("[transfer]\nsun = \"SH\"", "must be one of \"directional\", \"sh\", \"none\"");
  checkSectionRefused("[transfer]\nlocal_lights = 1", "list of sectors");
  for (const char* name : {"1", "1_", "_1", "01_1", "-0_1", "1_2_3", "1_x", "15626_0", "0_-15626", " 1_1"})
    checkSectionRefused(fmt::format("[transfer]\nlocal_lights = [\"0_0\", \"{}\"]", name), "no sector");
  checkSectionRefused("[transfer]\nlocal_lights = [\"1_1\", \"0_0\", \"1_1\"]", "twice");
  try {
    sectionOf("[[room]]\n");
    FAIL("it was read");
  } catch (const base::Error& e) {
    CHECK_THAT(e.what(), Catch::Contains("room[0].box: is missing"));
  }
}

TEST_CASE("SectorName, ReadsWhatItWrites") {
  for (const geometry::SectorId sector :
       {geometry::SectorId{0, 0}, {-1, 12}, {geometry::kFarthestSector, -geometry::kFarthestSector}})
    CHECK(geometry::sectorOf(nameOf(sector)) == sector);
  CHECK(geometry::fileNameOf({-1, 12}) == "sector_-1_12.welkin");
}

}  // namespace welkin::tests
