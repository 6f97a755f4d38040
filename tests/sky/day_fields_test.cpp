// SPDX-License-Identifier: Apache-2.0
// The measure of a day: hours, normals and divisors.
#include "sky/table/day_fields.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "sampled_day.h"

namespace welkin::tests {

using det::Number3;

TEST_CASE("DayFields, DividesByTheMeanAndNeverByLessThanAShareOfTheBrightest") {
  // A uniform sky over a ground: the mean of E over all normals is pi / 2 (1 + albedo) times the radiance.
  model::Sky sky = stillSky(*model::findLuminance("cie-5"), 30.0);
  sky.ground_albedo = Number3(0.2);
  sky.intensity = {1, {0.0, 12.0}, {1e-7, 3.0}};
  const SampledDay day(sky, {0.0, 6.0, 12.0});
  const double brightest = 3.0 * M_PI / 2.0 * 1.2;
  constexpr double kQuadrature = 1e-5;
  for (int c = 0; c < 3; ++c) {
    CHECK(day.fields.instant[0].divisor[c] == Approx(1e-4 * brightest).epsilon(kQuadrature));
    CHECK(day.fields.instant[1].divisor[c] == Approx(0.5 * brightest).epsilon(kQuadrature));
    CHECK(day.fields.instant[2].divisor[c] == Approx(brightest).epsilon(kQuadrature));
  }
}

TEST_CASE("DayFields, AChannelIsDividedByTheLuminanceWhenThatIsMore") {
  model::Sky sky = stillSky(*model::findLuminance("cie-5"), 30.0);
  sky.gradient_sun = sky.gradient_anti = model::Gradient::constant({2.0, 1.0, 0.1});
  model::normalise(sky.gradient_sun, sky.gradient_anti);
  const SampledDay day(sky, {12.0});
  const double luminance = 0.2126 * 2.0 + 0.7152 + 0.0722 * 0.1;
  const Number3& divisor = day.fields.instant[0].divisor;
  CHECK(divisor.x == Approx(M_PI / 2.0 * 2.0 / luminance).epsilon(1e-5));
  CHECK(divisor.y == Approx(M_PI / 2.0).epsilon(1e-5));
  CHECK(divisor.z == Approx(M_PI / 2.0).epsilon(1e-5));
}

TEST_CASE("HoursOfInterest, HoldTheSunsRisingSettingAndHeight") {
  // A hand-drawn sun crosses the horizon at 7 h and at 18 + 10 / 3 h. For a place it is highest at its transit.
  constexpr double kSecond = 1.0 / 3600.0;
  const auto holds = [](const std::vector<double>& hours, double t) {
    return std::any_of(hours.begin(), hours.end(), [&](double h) { return std::abs(h - t) <= kSecond; });
  };
  model::Sky sky = stillSky(*model::findLuminance("cie-5"), 0.0);
  sky.sun.path.key_time_h = {4.0, 10.0, 18.0, 23.0};
  sky.sun.path.key_azimuth_rad = {1.0, 2.0, 4.0, 5.0};
  sky.sun.path.key_elevation_rad = {-0.3, 0.3, 0.2, -0.1};
  const auto by_hand = table::hoursOfInterest(sky, 3.0);
  for (const double t : {0.0, 3.0, 21.0, 4.0, 10.0, 18.0, 23.0, 7.0, 18.0 + 10.0 / 3.0}) {
    CAPTURE(t);
    CHECK(holds(by_hand, t));
  }
  CHECK(by_hand.size() < 20);
  CHECK(std::is_sorted(by_hand.begin(), by_hand.end()));

  model::Sky placed;
  placed.sun.path = model::sunPathFromPlace(17.0, -3.5, 0.0, 2012, 172);
  CHECK(holds(table::hoursOfInterest(placed, 3.0), placed.sun.path.transit_h));
}

}  // namespace welkin::tests
