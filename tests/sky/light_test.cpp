// SPDX-License-Identifier: Apache-2.0
// Sun and moon: the almanac, hand-drawn paths, colour.
#include "sky/model/light.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "degree.h"

namespace welkin::tests {

using det::Number3;
namespace {

TEST_CASE("SunPath, MeeusExample") {
  // Meeus (1998), examples 25.a and 28.b: 13 October 1992, 0 h TD: declination -7.78507 degrees, equation of time
  // 13 min 42.7 s. Clock time 12 h is 0 h UT with an offset of 12 h.
  const model::LightPath path = model::sunPathFromPlace(40.0, 0.0, 12.0, 1992, 287);
  CHECK(path.declination_rad / kDegree == Approx(-7.78507).margin(0.003));  // aberration and nutation are left out
  CHECK(path.transit_h == Approx(24.0 - (13.0 + 42.7 / 60.0) / 60.0).margin(3.0 / 3600.0));
}

TEST_CASE("SunPath, CulminatesAndRisesWhereGeometrySays") {
  const model::LightPath path = model::sunPathFromPlace(48.0, 11.0, 1.0, 2020, 172);
  const auto noon = path.directionAt(path.transit_h);
  CHECK(det::elevationOf(noon) == Approx(M_PI / 2 - 48.0 * kDegree + path.declination_rad).margin(1e-12));
  CHECK(noon.z > 0.0);  // in the south
  CHECK(noon.x == Approx(0.0).margin(1e-12));
  // cos H = -tan latitude tan declination at the horizon; before transit the sun is in the east.
  const double hours = std::acos(-std::tan(48.0 * kDegree) * std::tan(path.declination_rad)) * 12.0 / M_PI;
  const auto rise = path.directionAt(path.transit_h - hours);
  CHECK(rise.y == Approx(0.0).margin(1e-12));
  CHECK(rise.x > 0.5);
  CHECK(path.directionAt(path.transit_h + hours).x < -0.5);
}

TEST_CASE("SunPath, TransitFollowsLongitudeAndClock") {
  const double greenwich = model::sunPathFromPlace(10.0, 0.0, 0.0, 2012, 172).transit_h;
  CHECK(model::sunPathFromPlace(10.0, 30.0, 0.0, 2012, 172).transit_h == Approx(greenwich - 2.0).margin(1e-3));
  CHECK(model::sunPathFromPlace(10.0, 30.0, 2.0, 2012, 172).transit_h == Approx(greenwich).margin(1e-3));
}

TEST_CASE("SunPath, NorthOffsetTurnsClockwise") {
  model::LightPath path = model::sunPathFromPlace(20.0, 0.0, 0.0, 2000, 100);
  const auto before = path.directionAt(9.0);
  path.north_offset_rad = 0.4;
  const auto after = path.directionAt(9.0);
  const double turn = std::remainder(std::atan2(after.x, -after.z) - std::atan2(before.x, -before.z), 2 * M_PI);
  CHECK(turn == Approx(0.4).margin(1e-12));
  CHECK(after.y == Approx(before.y).margin(1e-15));
}

TEST_CASE("HandPath, GoesTheShortWayAndWraps") {
  model::LightPath path;
  path.key_time_h = {6.0, 18.0};
  path.key_azimuth_rad = {350.0 * kDegree, 10.0 * kDegree};
  path.key_elevation_rad = {0.2, 0.4};
  const auto noon = path.directionAt(12.0);
  const auto expected = det::directionOf(0.0, 0.3);
  CHECK(noon.x == Approx(expected.x).margin(1e-12));
  CHECK(noon.z == Approx(expected.z).margin(1e-12));
  const auto midnight = path.directionAt(0.0);  // back over north from 18 h to 6 h
  CHECK(midnight.y == Approx(std::sin(0.3)).margin(1e-12));
  CHECK(midnight.z == Approx(expected.z).margin(1e-12));
}

TEST_CASE("HandPath, HalfATurnGoesClockwise") {
  model::LightPath path;
  path.key_time_h = {0.0, 12.0};
  path.key_azimuth_rad = {0.0, M_PI};
  path.key_elevation_rad = {0.0, 0.0};
  CHECK(path.directionAt(6.0).x == Approx(1.0));    // north to south over the east
  CHECK(path.directionAt(18.0).x == Approx(-1.0));  // and back over the west
}

TEST_CASE("HandPath, HalfATurnGoesClockwiseWhateverItsRounding") {
  for (int from_deg = 0; from_deg < 360; ++from_deg)
    for (const double north_deg : {0.0, 20.0, -33.3}) {
      model::LightPath path;
      path.key_time_h = {0.0, 12.0};
      for (const double azimuth_deg : {from_deg + 0.0, std::fmod(from_deg + 180.0, 360.0)})
        path.key_azimuth_rad.push_back(azimuth_deg * kDegree + north_deg * kDegree);
      path.key_elevation_rad = {0.0, 0.0};
      const auto expected = det::directionOf((from_deg + north_deg + 90.0) * kDegree, 0.0);
      CAPTURE(from_deg, north_deg);
      CHECK(dot(path.directionAt(6.0), expected) == Approx(1.0));
    }
}

TEST_CASE("Light, IlluminanceIsTheLuminanceOfItsIrradiance") {
  model::Light light;
  light.illuminance = base::Curve::constant(3.0);
  light.colour = base::Curve::constant(Number3(2.0, 0.5, 0.25));
  const auto e = light.normalIrradianceAt(5.0);
  CHECK(det::luminanceOf(e) == Approx(3.0).epsilon(1e-14));
  CHECK(e.x / e.z == Approx(8.0).epsilon(1e-14));
}

TEST_CASE("Light, LevelGroundGetsTheSineOfItsElevationAndGivesBackItsAlbedo") {
  const Number3 irradiance(3.0, 2.0, 1.0);
  const Number3 from_above = det::levelIrradiance(irradiance, det::directionOf(1.0, 30.0 * kDegree));
  const Number3 radiance = det::groundRadiance(Number3(0.5, 0.25, 1.0), from_above);
  const double want[] = {0.75 / M_PI, 0.25 / M_PI, 0.5 / M_PI};
  for (int c = 0; c < 3; ++c) CHECK(radiance[c] == Approx(want[c]).epsilon(1e-14));
  CHECK(det::levelIrradiance(irradiance, det::directionOf(1.0, -30.0 * kDegree)) == Number3(0.0));
  CHECK(det::normalIrradiance(Number3(0.0), 2.0) == Number3(0.0));
}

TEST_CASE("Curve, PiecewiseLinearAndPeriodic") {
  const base::Curve curve{1, {6.0, 12.0, 20.0}, {1.0, 4.0, 2.0}};
  CHECK(curve.at(6.0) == 1.0);
  CHECK(curve.at(8.0) == Approx(2.0));
  CHECK(curve.at(16.0) == Approx(3.0));
  CHECK(curve.at(1.0) == Approx(1.5));     // half way from 20 h to 6 h
  CHECK(curve.at(25.0) == curve.at(1.0));  // wraps
  CHECK(curve.at(-23.0) == curve.at(1.0));
  CHECK(curve.at(24.0) == curve.at(0.0));
  CHECK(curve.at(-1e-20) == Approx(curve.at(0.0)));
}

}  // namespace
}  // namespace welkin::tests
