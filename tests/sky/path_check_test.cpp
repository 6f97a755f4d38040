// SPDX-License-Identifier: Apache-2.0
// Warnings of paths: given for mistakes, and only for them.
#include "sky/model/path_check.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "degree.h"
#include "sky/bake/sky_file.h"
#include "tests/folder.h"

namespace welkin::tests {
namespace {

struct Key {
  double time_h, azimuth_deg, elevation_deg;
};

model::LightPath byHand(const std::vector<Key>& keys, double north_offset_deg = 0.0) {
  model::LightPath path;
  path.north_offset_rad = north_offset_deg * kDegree;
  for (const Key& key : keys) {
    path.key_time_h.push_back(key.time_h);
    path.key_azimuth_rad.push_back(key.azimuth_deg * kDegree + path.north_offset_rad);
    path.key_elevation_rad.push_back(key.elevation_deg * kDegree);
  }
  return path;
}

std::vector<std::string> idsOf(const model::LightPath& path) {
  std::vector<std::string> ids;
  for (const model::Warning& w : model::pathWarningsOf(path, "sun")) ids.push_back(w.id);
  return ids;
}

const std::vector<std::string> kNone;
const std::vector<std::string> kOnHorizon = {"on-horizon"};

}  // namespace

TEST_CASE("Culmination, IsTheHighestOfTheDay") {
  for (const double declination_deg : {-90.0, -23.4, 0.0, 23.4, 90.0})
    for (const double latitude_deg : {-90.0, -10.0, 0.0, 40.0, 90.0}) {
      model::LightPath path;
      path.declination_rad = declination_deg * kDegree;
      path.latitude_rad = latitude_deg * kDegree;
      path.transit_h = 37.5;
      const model::Culmination top = model::culminationOf(path);
      CHECK(top.time_h == 13.5);
      const double there = path.directionAt(top.time_h).y;
      CHECK(there == Approx(std::sin(top.elevation_rad)).margin(1e-12));
      for (double t = 0.0; t < 24.0; t += 0.1) REQUIRE(path.directionAt(t).y <= there + 1e-12);
    }
  const model::Culmination key = model::culminationOf(byHand({{3, 0, -5}, {9, 90, 20}, {15, 180, 20}, {20, 0, 1}}));
  CHECK(key.time_h == 9.0);
  CHECK(key.elevation_rad == Approx(20.0 * kDegree));
}

TEST_CASE("PathWarnings, SunLeftOnTheHorizonOvernight") {
  const model::LightPath path = byHand({{6, 90, 0}, {12, 180, 60}, {18, 270, 0}});
  const auto stretches = model::horizonStretchesOf(path);
  REQUIRE(stretches.size() == 1);
  CHECK(stretches[0].from_h == 18.0);
  CHECK(stretches[0].length_h == 12.0);
  const auto warnings = model::pathWarningsOf(path, "sun");
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].id == "on-horizon");
  CHECK(warnings[0].count == 1);
  CHECK(warnings[0].message ==
        "the sun lies on the horizon from 18 h to 6 h (12 hours); if it should set, add a key below the horizon, for "
        "example [0, 0, -30]");
}

TEST_CASE("PathWarnings, TheProposedKeyMends") {
  CHECK(idsOf(byHand({{0, 0, -30}, {6, 90, 0}, {12, 180, 60}, {18, 270, 0}})) == kNone);
  // Warnings propose azimuths as the file writes them, without the north offset.
  const auto warnings = model::pathWarningsOf(byHand({{6, 80, 0}, {12, 180, 60}, {17, 280, 0}}, 33.0), "moon");
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].message.find("the moon lies on the horizon from 17 h to 6 h (13 hours)") == 0);
  CHECK(warnings[0].message.find("[23.5, 0, -30]") != std::string::npos);
}

TEST_CASE("PathWarnings, BandAndHoursHaveEdges") {
  const auto overnight = [](double first_deg, double last_deg, double rise_h = 6.0, double set_h = 18.0) {
    return idsOf(byHand({{rise_h, 90, first_deg}, {12, 180, 60}, {set_h, 270, last_deg}}));
  };
  CHECK(overnight(0.5, -0.5) == kOnHorizon);
  CHECK(overnight(std::nextafter(0.5, 1.0), 0.0) == kNone);
  CHECK(overnight(0.0, std::nextafter(-0.5, -1.0)) == kNone);
  CHECK(overnight(0.0, 0.0, 0.25, 23.25) == kNone);  // an hour
  CHECK(overnight(0.0, 0.0, 0.25, 23.24) == kOnHorizon);
}

TEST_CASE("PathWarnings, NeighboursAreOneStretch") {
  const model::LightPath path = byHand(
      {{2, 30, 0}, {5, 80, 0.2}, {10, 150, 40}, {14, 210, 0}, {16, 220, 0}, {18, 250, -9}, {20, 270, 0}, {22, 0, 0}});
  const auto stretches = model::horizonStretchesOf(path);
  REQUIRE(stretches.size() == 2);
  CHECK(stretches[0].from_h == 14.0);
  CHECK(stretches[0].length_h == 2.0);
  CHECK(stretches[1].from_h == 20.0);
  CHECK(stretches[1].length_h == 9.0);  // to 5 h, over midnight
  CHECK(model::pathWarningsOf(path, "sun")[0].count == 2);
}

TEST_CASE("PathWarnings, NoneWhereTheHorizonIsMeant") {
  CHECK(idsOf(byHand({{0, 90, 0}})) == kNone);                     // a sunset that lasts
  CHECK(idsOf(byHand({{0, 90, 0.1}, {12, 270, -0.1}})) == kNone);  // around the horizon all day
  CHECK(idsOf(byHand({{0, 180, 60}})) == kNone);                   // stands still
  CHECK(idsOf(byHand({{0, 0, -60}, {12, 180, 60}})) == kNone);     // crosses it
  CHECK(idsOf(byHand({{5, 80, -0.5}, {5.5, 90, 0.5}, {12, 180, 50}, {18, 270, -6}})) == kNone);  // rises slowly
  for (const int day : {80, 172, 266, 355}) CHECK(idsOf(model::sunPathFromPlace(90.0, 0.0, 0.0, 2000, day)) == kNone);
}

TEST_CASE("PathWarnings, HandPathThatNeverRises") {
  const auto warnings = model::pathWarningsOf(byHand({{0, 0, -60}, {12, 180, -5.2}}), "sun");
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].id == "never-rises");
  CHECK(warnings[0].message == "the sun never rises: it is highest at 12 h, 5.2 degrees below the horizon");
  CHECK(idsOf(byHand({{0, 0, -60}, {12, 180, 0}})) == kNone);
  CHECK(idsOf(byHand({{0, 0, -60}, {6, 90, -0.1}, {18, 270, -0.1}})) ==
        std::vector<std::string>{"never-rises", "on-horizon"});
}

TEST_CASE("SkyFile, WarningsNameFileLineAndLight") {
  const Folder folder;
  const auto read = [&](const std::string& text) {
    return bake::readSkyFile(folder.write("some.toml", "[sky]\nluminance = \"cie-5\"\n" + text)).warnings;
  };
  const auto warnings = read(
      "[sun]\npath = [[6, 90, 0], [12, 180, 60], [18, 270, 0]]\n[moon]\nilluminance = 1\npath = [\n  [0, 0, -5]]\n");
  REQUIRE(warnings.size() == 2);
  CHECK(warnings[0].id == "sun-on-horizon");
  CHECK(warnings[0].message.find("some.toml:4: sun.path: the sun lies on the horizon") == 0);
  CHECK(warnings[1].id == "moon-never-rises");
  CHECK(warnings[1].message.find("some.toml:7: moon.path: the moon never rises") == 0);
  CHECK(read("[sun]\nlatitude_deg = 80\nday_of_year = 355\n[moon]\ndeclination_deg = -20\nphase = 0.5\n").empty());
}

}  // namespace welkin::tests
