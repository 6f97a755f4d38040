// SPDX-License-Identifier: Apache-2.0
// Compares the sun and the moon with libnova, on dates and places all over.
//
// A path freezes the declination and the hour angle's lead over the clock for a day. It ignores how far the light moves
// against a point that turns with the mean sun. The bound is therefore a speed times the hours since the frozen moment,
// plus a small part for the series:
//
// - The sun moves on the ecliptic, by at most 1.0194 degrees a day (perihelion, in January), and a turning mean sun
//   follows its right ascension at 0.9856. At an equinox 0.395 of declination and 0.075 of right ascension are left, at
//   the winter solstice 0.125 x cos 23.4. The largest of the hypotenuses from 1600 to 2400 is 0.403 degrees a day.
// - Series: the true longitude is good to 0.01 degrees (Meeus, ch. 25), of which sin 23.4 is declination and the rest
//   right ascension. Aberration, left out of the declination, is 0.0057 x sin 23.4. Smart's series for the equation of
//   time is cut at the square of its small numbers, which costs at most 0.0121 degrees on the sky from 1600 to 2400.
//   Declination 0.0063 and hour angle 0.0221 make 0.023 degrees. The path takes UT for dynamical time: the sun's speed
//   x delta T.
// - The moon, without its parallax of 1 degree, moves by at most 15.4 degrees a day (perigee), mostly east like the
//   mean sun's 0.9856: 14.5 are left, among them up to 7.3 of declination. At its transit the hour angle is right but
//   for the sun's own drift since 12 h, 0.126 degrees a day.
//
// Largest errors seen, relative to the bound: the sun 0.63 at 12 h (0.0146 degrees), 0.91 at other hours; the moon 0.70
// at its transit, 0.99 around it.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "nova.h"
#include "sky/bake/sky_file.h"
#include "tests/folder.h"

namespace welkin::tests {

using det::Number3;
namespace {

constexpr double kSunSpeed_deg_day = 0.403;
constexpr double kEquationOfTimeSpeed_deg_day = 0.126;
constexpr double kDeclination_deg = 0.0063;
constexpr double kHourAngle_deg = 0.0221;  // times the cosine of the declination
constexpr double kSeries_deg = 0.023;
constexpr double kMoonSpeed_deg_day = 14.5;

struct Place {
  double latitude_deg, longitude_deg, utc_offset_h;
  int year, day_of_year;
};

/// 200 dates and places: every tenth date from 1600 to 2400, the others from 1900 to 2100; latitudes from pole to pole,
/// the first two the poles; offsets of the longitude, of the clocks' ends and of quarter hours.
std::vector<Place> places() {
  std::mt19937_64 random(2024);  // The standard fixes its numbers, unlike those of distributions.
  const auto between = [&random](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  std::vector<Place> places;
  for (int i = 0; i < 200; ++i) {
    Place p{};
    p.latitude_deg = i < 2 ? 180.0 * i - 90.0 : between(-90.0, 90.0);
    p.longitude_deg = i % 25 == 2 ? 180.0 : between(-180.0, 180.0);
    const double offsets_h[] = {p.longitude_deg / 15.0, 14.0, -12.0, std::floor(between(-48.0, 56.0)) / 4.0};
    p.utc_offset_h = offsets_h[i % 4];
    p.year = static_cast<int>(i % 10 == 9 ? between(1600.0, 2401.0) : between(1900.0, 2101.0));
    p.day_of_year = 1 + static_cast<int>(between(0.0, 366.0));
    places.push_back(p);
  }
  return places;
}

std::string written(const Place& p, double time_h) {
  return "latitude " + std::to_string(p.latitude_deg) + ", longitude " + std::to_string(p.longitude_deg) + ", offset " +
         std::to_string(p.utc_offset_h) + ", day " + std::to_string(p.day_of_year) + " of " + std::to_string(p.year) +
         ", " + std::to_string(time_h) + " h";
}

double angle_deg(const Number3& a, const Number3& b) {
  const double x = a.y * b.z - a.z * b.y;
  const double y = a.z * b.x - a.x * b.z;
  const double z = a.x * b.y - a.y * b.x;
  return std::atan2(std::sqrt(x * x + y * y + z * z), a.x * b.x + a.y * b.y + a.z * b.z) * 180.0 / M_PI;
}

double julianDayOf(const Place& p, double time_h) {
  return welkin::tests::julianDayOf(p.year, p.day_of_year, time_h - p.utc_offset_h);
}

/// The largest ratio of an error to its bound, and where it occurs.
struct Worst {
  double error_deg = 0.0;
  double share = 0.0;  ///< of the bound
  std::string where;

  void add(double error, double bound, const std::string& at) {
    const double part = std::isfinite(error) ? error / bound : HUGE_VAL;
    if (part <= share) return;
    error_deg = error;
    share = part;
    where = at;
  }
};

}  // namespace

TEST_CASE("Almanac, ReferenceAgreesWithMeeus") {
  // Examples 25.b and 47.a, 0 h of dynamical time; longitudes without nutation (0.004419 degrees in the first).
  constexpr double kBetweenTheories_deg = 5e-4;
  const auto universal = [](int day) {
    const double jd = julianDayOf(1992, day, 0.0);
    return jd - deltaT_s(jd) / 86400.0;
  };
  const double october = universal(287);
  const Equatorial sun = novaSun(october);
  CHECK(eclipticLongitudeOf_deg(sun, october) == Approx(199.906061 - 0.004419).margin(kBetweenTheories_deg));
  CHECK(sun.declination_deg == Approx(-7.7822).margin(kBetweenTheories_deg));
  const double april = universal(103);
  const Equatorial moon = novaMoon(april);
  CHECK(eclipticLongitudeOf_deg(moon, april) == Approx(133.162655).margin(kBetweenTheories_deg));
}

TEST_CASE("Almanac, SunIsWhereLibnovaHasIt") {
  Worst noon, day;
  for (const Place& p : places()) {
    const model::LightPath path =
        model::sunPathFromPlace(p.latitude_deg, p.longitude_deg, p.utc_offset_h, p.year, p.day_of_year);
    for (const double time_h : {0.0, 1.7, 3.0, 6.0, 9.1, 11.0, 12.0, 13.5, 15.0, 18.0, 20.9, 23.99}) {
      const double jd = julianDayOf(p, time_h);
      const Number3 expected = novaDirectionOf(novaSun(jd), jd, p.latitude_deg, p.longitude_deg);
      const double error = angle_deg(path.directionAt(time_h), expected);
      const double small = kSeries_deg + kSunSpeed_deg_day * std::abs(deltaT_s(jd)) / 86400.0;
      const double bound = small + kSunSpeed_deg_day * std::abs(time_h - 12.0) / 24.0;
      (time_h == 12.0 ? noon : day).add(error, bound, written(p, time_h));
    }
  }
  INFO("at 12 h " << noon.error_deg << " degrees, " << noon.share << " of the bound: " << noon.where);
  INFO("at other hours " << day.error_deg << " degrees, " << day.share << " of the bound: " << day.where);
  CHECK(noon.share <= 1.0);
  CHECK(noon.share > 0.3);
  CHECK(day.share <= 1.0);
  CHECK(day.share > 0.8);  // A bound that no error approaches proves nothing.
}

TEST_CASE("Almanac, SunsDeclinationAndHourAngleAtTheFrozenMoment") {
  Worst declination, hour_angle;
  for (const Place& p : places()) {
    const model::LightPath path =
        model::sunPathFromPlace(p.latitude_deg, p.longitude_deg, p.utc_offset_h, p.year, p.day_of_year);
    const double jd = julianDayOf(p, 12.0);
    const Equatorial sun = novaSun(jd);
    const double delay = kSunSpeed_deg_day * std::abs(deltaT_s(jd)) / 86400.0;
    declination.add(std::abs(path.declination_rad * 180.0 / M_PI - sun.declination_deg), kDeclination_deg + delay,
                    written(p, 12.0));
    const double ahead_deg = 15.0 * (12.0 - path.transit_h) - hourAngleOf_deg(sun, jd, p.longitude_deg);
    hour_angle.add(std::abs(std::remainder(ahead_deg, 360.0)) * std::cos(path.declination_rad), kHourAngle_deg + delay,
                   written(p, 12.0));
  }
  INFO("declination " << declination.error_deg << ", " << declination.share << " of the bound: " << declination.where);
  INFO("hour angle " << hour_angle.error_deg << ", " << hour_angle.share << " of the bound: " << hour_angle.where);
  CHECK(declination.share <= 1.0);
  CHECK(hour_angle.share <= 1.0);
}

TEST_CASE("Almanac, MoonStaysNearLibnovasAroundItsTransit") {
  const Folder folder;
  Worst transit, hours;
  for (const Place& p : places()) {
    // The transit nearest to 12 h: the hour angle grows by 15 degrees an hour less the moon's own.
    double transit_h = 12.0;
    for (int i = 0; i < 6; ++i) {
      const double jd = julianDayOf(p, transit_h);
      transit_h -= hourAngleOf_deg(novaMoon(jd), jd, p.longitude_deg) / 14.49;
    }
    const double jd = julianDayOf(p, transit_h);
    const Equatorial moon = novaMoon(jd);
    // The phase is the elongation in right ascension: how far behind the sun the moon crosses the meridian.
    const double elongation_deg = moon.right_ascension_deg - novaSun(jd).right_ascension_deg;
    const double phase = elongation_deg / 360.0 - std::floor(elongation_deg / 360.0);
    char text[512];
    std::snprintf(text, sizeof text,
                  "[sky]\nluminance = \"cie-5\"\n[sun]\nlatitude_deg = %.17g\nlongitude_deg = %.17g\n"
                  "utc_offset_h = %.17g\nyear = %d\nday_of_year = %d\n[moon]\ndeclination_deg = %.17g\nphase = %.17g\n",
                  p.latitude_deg, p.longitude_deg, p.utc_offset_h, p.year, p.day_of_year, moon.declination_deg, phase);
    const bake::SkyFile file = bake::readSkyFile(folder.write("sky.toml", text));
    const model::LightPath& path = file.sky.moon->path;
    const double at_transit = kSeries_deg + kSunSpeed_deg_day * std::abs(deltaT_s(jd)) / 86400.0 +
                              kEquationOfTimeSpeed_deg_day * std::abs(transit_h - 12.0) / 24.0;
    for (const double since_h : {-6.0, -4.5, -3.0, -1.0, 0.0, 1.0, 2.0, 4.0, 6.0}) {
      const double time_h = transit_h + since_h;
      const double then = julianDayOf(p, time_h);
      const Number3 expected = novaDirectionOf(novaMoon(then), then, p.latitude_deg, p.longitude_deg);
      const double error = angle_deg(path.directionAt(time_h), expected);
      const double bound = at_transit + kMoonSpeed_deg_day * std::abs(since_h) / 24.0;
      (since_h == 0.0 ? transit : hours).add(error, bound, written(p, time_h));
    }
  }
  INFO("at its transit " << transit.error_deg << " degrees, " << transit.share << " of the bound: " << transit.where);
  INFO("hours from it " << hours.error_deg << " degrees, " << hours.share << " of the bound: " << hours.where);
  CHECK(transit.share <= 1.0);
  CHECK(hours.share <= 1.0);
  CHECK(hours.share > 0.8);
}

}  // namespace welkin::tests
