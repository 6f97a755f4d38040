// SPDX-License-Identifier: Apache-2.0
// The sun's path at the ends of its domain: poles and equator, polar day and night, the date line, calendars, clocks.
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>

#include "degree.h"
#include "sky/bake/sky_file.h"
#include "sky/base/error.h"
#include "sky/model/path_check.h"
#include "tests/folder.h"

namespace welkin::tests {

using det::Number3;
namespace {

constexpr double kPathRounding = 1e-12;                   // of a few products in double; hours, radians
constexpr double kEquationOfTime_h_day = 30.3 / 3600.0;   // its fastest change, at a winter solstice
constexpr double kDeclination_rad_day = 0.403 * kDegree;  // its fastest change is below the sun's own
constexpr double kStep_h = 1.0 / 60.0;

double lowest(const model::LightPath& path) {
  double y = 1.0;
  for (double t = 0.0; t < 24.0; t += kStep_h) y = std::min(y, path.directionAt(t).y);
  return std::asin(y);
}

double highest(const model::LightPath& path) {
  double y = -1.0;
  for (double t = 0.0; t < 24.0; t += kStep_h) y = std::max(y, path.directionAt(t).y);
  return std::asin(y);
}

void requireSame(const model::LightPath& a, const model::LightPath& b) {
  for (double t = 0.0; t < 24.0; t += 0.5) {
    const Number3 p = a.directionAt(t);
    const Number3 q = b.directionAt(t);
    REQUIRE(p.x == Approx(q.x).margin(kPathRounding));
    REQUIRE(p.y == Approx(q.y).margin(kPathRounding));
    REQUIRE(p.z == Approx(q.z).margin(kPathRounding));
  }
}

model::LightPath sunOf(const std::string& keys) {
  const Folder folder;
  return bake::readSkyFile(folder.write("sky.toml", "[sky]\nluminance = \"cie-5\"\n[sun]\n" + keys)).sky.sun.path;
}

}  // namespace

TEST_CASE("SunPath, PolarDayNeverSets") {
  const model::LightPath path = model::sunPathFromPlace(78.0, 15.6, 1.0, 2021, 172);
  // At its lower transit the sun is 12 degrees, the pole's distance, below its declination.
  CHECK(lowest(path) == Approx(path.declination_rad - 12.0 * kDegree).margin(1e-5));
  CHECK(lowest(path) > 11.0 * kDegree);
  CHECK(path.directionAt(path.transit_h + 12.0).z < 0.0);  // in the north at midnight
}

TEST_CASE("SunPath, PolarNightNeverRises") {
  for (const auto& [latitude_deg, day] : {std::pair(78.0, 355), {-78.0, 172}}) {
    const model::LightPath path = model::sunPathFromPlace(latitude_deg, 15.6, 1.0, 2021, day);
    const double expected = 12.0 * kDegree - std::abs(path.declination_rad);
    CHECK(highest(path) == Approx(expected).margin(1e-5));
    CHECK(highest(path) < -11.0 * kDegree);
    CHECK(model::culminationOf(path).elevation_rad == Approx(expected).margin(kPathRounding));
  }
}

TEST_CASE("SunPath, PolesKeepTheElevation") {
  for (const double latitude_deg : {90.0, -90.0})
    for (const int day : {1, 80, 172, 266, 355}) {
      const model::LightPath path = model::sunPathFromPlace(latitude_deg, 40.0, 0.0, 2010, day);
      const double expected = latitude_deg > 0.0 ? path.declination_rad : -path.declination_rad;
      for (double t = 0.0; t < 24.0; t += 0.25)
        REQUIRE(det::elevationOf(path.directionAt(t)) == Approx(expected).margin(kPathRounding));
      // From above the north pole the sun goes clockwise, from above the south pole counterclockwise.
      const Number3 now = path.directionAt(10.0);
      const Number3 then = path.directionAt(11.0);
      CHECK((now.x * then.z - now.z * then.x > 0.0) == (latitude_deg > 0.0));
    }
}

TEST_CASE("SunPath, EquinoxOnTheEquatorGoesThroughTheZenith") {
  for (const int day : {79, 266}) {
    const model::LightPath path = model::sunPathFromPlace(0.0, 0.0, 0.0, 2019, day);
    const double near_h = 0.41 * kDegree;  // a day's declination
    REQUIRE(std::abs(path.declination_rad) < near_h);
    CHECK(det::elevationOf(path.directionAt(path.transit_h)) ==
          Approx(M_PI / 2.0 - std::abs(path.declination_rad)).margin(kPathRounding));
    const Number3 rise = path.directionAt(path.transit_h - 6.0);  // due east, six hours before
    CHECK(rise.x == Approx(1.0).margin(1e-4));
    CHECK(rise.y == Approx(0.0).margin(kPathRounding));
    CHECK(path.directionAt(path.transit_h + 6.0).x == Approx(-1.0).margin(1e-4));
    CHECK(path.directionAt(path.transit_h + 12.0).y == Approx(-1.0).margin(1e-4));
  }
}

TEST_CASE("SunPath, DateLineIsOnePlace") {
  for (const double latitude_deg : {-65.0, -17.0, 0.0, 52.0}) {
    // One instant, two dates: 12 h on the eastern clock is 12 h of the day before on the western.
    const model::LightPath east = model::sunPathFromPlace(latitude_deg, 180.0, 12.0, 2008, 61);
    const model::LightPath west = model::sunPathFromPlace(latitude_deg, -180.0, -12.0, 2008, 60);
    CHECK(west.declination_rad == Approx(east.declination_rad).margin(kPathRounding));
    CHECK(west.transit_h == Approx(east.transit_h).margin(kPathRounding));
    requireSame(east, west);
    // One date and clock time on the same meridian. The transits are a day apart, which is no difference.
    requireSame(east, model::sunPathFromPlace(latitude_deg, -180.0, 12.0, 2008, 61));
  }
}

TEST_CASE("SunPath, UtcOffsetShiftsTheClock") {
  for (const int day : {45, 100, 172, 307, 356}) {
    // The same instant at 12 h: the same sun, 24 hours later on the clock.
    const model::LightPath early = model::sunPathFromPlace(30.0, 20.0, -12.0, 2015, day);
    const model::LightPath late = model::sunPathFromPlace(30.0, 20.0, 12.0, 2015, day + 1);
    CHECK(late.declination_rad == Approx(early.declination_rad).margin(kPathRounding));
    CHECK(late.transit_h - early.transit_h == Approx(24.0).margin(kPathRounding));
    // On one date only the frozen instant moves.
    const model::LightPath zero = model::sunPathFromPlace(30.0, 20.0, 0.0, 2015, day);
    for (const double offset_h : {-12.0, -3.5, 5.75, 14.0}) {
      const model::LightPath path = model::sunPathFromPlace(30.0, 20.0, offset_h, 2015, day);
      const double days = std::abs(offset_h) / 24.0;
      CHECK(path.transit_h - zero.transit_h == Approx(offset_h).margin(days * kEquationOfTime_h_day));
      CHECK(path.declination_rad == Approx(zero.declination_rad).margin(days * kDeclination_rad_day));
    }
  }
}

TEST_CASE("SunPath, DefaultOffsetIsTheLongitudes") {
  for (const std::string longitude : {"-180", "-97.5", "0", "13.25", "180"}) {
    const std::string place = "latitude_deg = 40\nday_of_year = 200\nlongitude_deg = " + longitude;
    const model::LightPath path = sunOf(place);
    const model::LightPath expected =
        model::sunPathFromPlace(40.0, std::stod(longitude), std::stod(longitude) / 15.0, 2000, 200);
    CHECK(path.transit_h == expected.transit_h);
    CHECK(path.declination_rad == expected.declination_rad);
    CHECK(path.transit_h == Approx(12.0).margin(0.3));  // local solar time but for the equation of time
    CHECK(sunOf(place + "\nutc_offset_h = 3").transit_h != path.transit_h);
  }
}

TEST_CASE("SunPath, DaysAreTheGregorianCalendars") {
  for (int year = -2000; year < 6000; ++year) {
    // Day 366 is the first day of the next year, or in a leap year a day of its own.
    const model::LightPath last = model::sunPathFromPlace(0.0, 0.0, 0.0, year, 366);
    const model::LightPath next = model::sunPathFromPlace(0.0, 0.0, 0.0, year + 1, 1);
    const bool is_same = last.declination_rad == next.declination_rad && last.transit_h == next.transit_h;
    INFO(year);
    REQUIRE(is_same == !std::chrono::year{year}.is_leap());
  }
}

TEST_CASE("SunPath, FiniteAndUnitOverItsWholeDomain") {
  for (const int year : {-2000, -1, 0, 1, 1582, 2000, 6000})
    for (int day = 1; day <= 366; day += 5)
      for (const double latitude_deg : {-90.0, -66.5, 0.0, 23.4, 90.0}) {
        const model::LightPath path = model::sunPathFromPlace(latitude_deg, 180.0, -14.0, year, day);
        REQUIRE(std::abs(path.declination_rad) < 24.0 * kDegree);  // the obliquity was 23.93 degrees
        for (double t = 0.0; t < 24.0; t += 2.3) {
          const Number3 d = path.directionAt(t);
          REQUIRE(dot(d, d) == Approx(1.0).margin(kPathRounding));
        }
      }
}

TEST_CASE("SunPath, LatitudeEndsAtThePolesToTheLastDigit") {
  constexpr double kPastPole = std::numeric_limits<double>::infinity();
  for (const double pole_deg : {90.0, -90.0}) {
    const model::LightPath at = model::sunPathFromPlace(pole_deg, 0.0, 0.0, 2000, 172);
    requireSame(at, model::sunPathFromPlace(std::nextafter(pole_deg, 0.0), 0.0, 0.0, 2000, 172));
    CHECK(std::abs(at.latitude_rad) <= M_PI / 2.0);
    char past[64];
    std::snprintf(past, sizeof past, "latitude_deg = %.17g\nday_of_year = 172",
                  std::nextafter(pole_deg, std::copysign(kPastPole, pole_deg)));
    CHECK_THROWS_AS(sunOf(past), base::Error);
    std::snprintf(past, sizeof past, "latitude_deg = %.17g\nday_of_year = 172", std::nextafter(pole_deg, 0.0));
    CHECK_NOTHROW(sunOf(past));
  }
  requireSame(model::sunPathFromPlace(0.0, 0.0, 0.0, 2000, 172), model::sunPathFromPlace(-0.0, -0.0, -0.0, 2000, 172));
  requireSame(model::sunPathFromPlace(0.0, 0.0, 0.0, 2000, 172), model::sunPathFromPlace(5e-324, 0.0, 0.0, 2000, 172));
}

}  // namespace welkin::tests
