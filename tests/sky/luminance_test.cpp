// SPDX-License-Identifier: Apache-2.0
// Luminance models against the standard's published values and closed forms.
#include "sky/model/luminance.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "sky/model/indicatrix_table.h"

namespace welkin::tests {
namespace {

constexpr double kOracle = 1e-12;  // the digits that the oracle values are given with

double relative(std::string_view name, double z, double azimuth, double sun_z, double sun_azimuth) {
  const model::LuminanceModel& m = *model::findLuminance(name);
  const double degree = M_PI / 180.0;
  const auto sun = det::directionOf(sun_azimuth * degree, (90.0 - sun_z) * degree);
  return det::relativeLuminance(m, det::directionOf(azimuth * degree, (90.0 - z) * degree), sun,
                                det::luminanceNorm(m, sun, false));
}

TEST_CASE("Luminance, PublishedValues") {
  // colour-science's tests of CIE S 011/E:2003, which agree with the standard's table 1.
  CHECK(det::indicatrix({0, -1, 10, -3, 0.45, 0}, M_PI / 6.0) == Approx(3.32646285329632).epsilon(kOracle));
  CHECK(relative("cie-1", 45, 180, 30, 0) == Approx(0.83258464279644).epsilon(kOracle));
  CHECK(relative("cie-12", 45, 180, 30, 0) == Approx(0.45445243068520).epsilon(kOracle));
  CHECK(det::gradation({4, -0.7, 0, -1, 0, 0}, 1.0) == Approx(1.0 + 4.0 * std::exp(-0.7)).epsilon(kOracle));
}

TEST_CASE("Luminance, TableOneSums") {
  // The sum of every column of the standard's table shows a wrong digit in any row.
  model::LuminanceModel sum{};
  for (int type = 1; type <= 15; ++type) {
    const model::LuminanceModel& m = *model::findLuminance("cie-" + std::to_string(type));
    sum = {sum.a + m.a, sum.b + m.b, sum.c + m.c, sum.d + m.d, sum.e + m.e, sum.k + m.k};
  }
  CHECK(sum.a == Approx(3.2));
  CHECK(sum.b == Approx(-9.59));
  CHECK(sum.c == Approx(104.0));
  CHECK(sum.d == Approx(-31.8));
  CHECK(sum.e == Approx(3.3));
  CHECK(sum.k == 0.0);
}

TEST_CASE("Luminance, LimitsAtTheHorizon") {
  for (const auto& [name, m] : model::namedLuminances()) {
    CAPTURE(name);
    CHECK(det::gradation(m, 0.0) == 1.0);
    CHECK(det::gradation(m, -4.4e-8) == 1.0);
    CHECK(f32::gradation({float(m.a), float(m.b), float(m.c), float(m.d), float(m.e), float(m.k)}, -4.4e-8F) == 1.0F);
    CHECK(det::gradation(m, 1e-4) == Approx(1.0).margin(3e-4));  // no step above it
    for (const double up : {std::numeric_limits<double>::denorm_min(), 1e-300, 1e-30, 1.1e-30, 1e-20})
      CHECK(det::gradation(m, up) == 1.0);
    CHECK(det::indicatrix(m, M_PI / 2.0) == Approx(1.0).margin(1e-15));
  }
}

TEST_CASE("Luminance, CieOvercastClosedForm") {
  for (const double z : {0.0, 30.0, 60.0, 90.0})
    CHECK(relative("cie-overcast", z, 77, 40, 0) ==
          Approx((1.0 + 2.0 * std::cos(z * M_PI / 180.0)) / 3.0).epsilon(1e-14));
}

TEST_CASE("Luminance, SunNormalisationDarkensTheZenith") {
  // Ratios of the notes for the Far Cry 3 constants, printed with two digits.
  const model::LuminanceModel& m = *model::findLuminance("far-cry-3");
  const double expected[][2] = {{80, 0.60}, {60, 0.21}, {30, 0.039}, {10, 0.0096}, {5, 0.0054}, {1, 0.0031}};
  for (const auto& [elevation, ratio] : expected) {
    const auto sun = det::directionOf(0.0, elevation * M_PI / 180.0);
    CAPTURE(elevation);
    CHECK(det::relativeLuminance(m, {0, 1, 0}, sun, det::luminanceNorm(m, sun, true)) == Approx(ratio).epsilon(0.03));
    CHECK(det::relativeLuminance(m, sun, sun, det::luminanceNorm(m, sun, true)) == Approx(1.0).epsilon(1e-12));
  }
}

TEST_CASE("Luminance, FloatFollowsDouble") {
  // The indicatrix' exponential amplifies a rounding of the angle by |d| = 3; a dozen roundings add up.
  constexpr double kFloat = 4e-6;
  for (const auto& [name, m] : model::namedLuminances()) {
    const f32::LuminanceModel mf{float(m.a), float(m.b), float(m.c), float(m.d), float(m.e), float(m.k)};
    for (const double sun_elevation : {-0.3, 0.0, 0.02, 0.7, M_PI / 2})
      for (double elevation = 0.0; elevation < 1.57; elevation += 0.0313) {
        const auto sun = det::directionOf(1.0, sun_elevation);
        const auto d = det::directionOf(1.0 + 3.0 * elevation, elevation);
        const auto norm = det::luminanceNorm(m, sun, true);
        const f32::Number3 sun_f(sun), d_f(d);
        const float got = f32::relativeLuminance(mf, d_f, sun_f, f32::luminanceNorm(mf, sun_f, true));
        const double want = det::relativeLuminance(m, det::Number3(d_f), det::Number3(sun_f),
                                                   det::luminanceNorm(m, det::Number3(sun_f), true));
        CAPTURE(name, sun_elevation, elevation, norm);
        REQUIRE(double{got} == Approx(want).epsilon(kFloat));
      }
  }
}

model::LightPath risingSun() {
  model::LightPath path;
  path.key_time_h = {0.0, 12.0};
  path.key_azimuth_rad = {0.0, M_PI};
  path.key_elevation_rad = {-0.5, 1.0};
  return path;
}

TEST_CASE("WhyUnusable, NamesCoefficientElevationAndDirection") {
  const auto sun = risingSun();
  for (const auto& [name, m] : model::namedLuminances()) {
    CAPTURE(name);
    CHECK_FALSE(model::whyUnusable(m, sun));
  }
  // The notes' misprint: c = -24 is darkest, and negative, at the sun.
  const auto misprint = model::whyUnusable({-1.0, -0.08, -24.0, -3.0, 0.30, 0.0}, sun);
  REQUIRE(misprint);
  CHECK_THAT(*misprint, Catch::Contains("c = -24") && Catch::Contains("sun elevation") && Catch::Contains("direction"));
  const auto zenith = model::whyUnusable({-2.0, -0.3, 0.0, -1.0, 0.0, 0.0}, sun);
  REQUIRE(zenith);
  CHECK_THAT(*zenith, Catch::Contains("a = -2") && Catch::Contains("(0, 1, 0)"));
  CHECK_THAT(*model::whyUnusable({0, 0.1, 0, -1, 0, 0}, sun), Catch::Contains("b = 0.1"));
  CHECK_THAT(*model::whyUnusable({0, -1, 0, 0.5, 0, 0}, sun), Catch::Contains("d = 0.5"));
}

TEST_CASE("WhyUnusable, DependsOnTheDaysSun") {
  // Negative only beyond 2.9 radians from the sun, which a sun in the zenith never shows above the horizon.
  const model::LuminanceModel m{0.0, -1.0, 0.0, -1.0, -1.05, 0.0};
  model::LightPath zenith;
  zenith.key_time_h = {0.0};
  zenith.key_azimuth_rad = {0.0};
  zenith.key_elevation_rad = {M_PI / 2};
  CHECK(model::whyUnusable(m, zenith));  // g(0) = 1 + e is negative too, and the sun's own direction is seen
  const model::LuminanceModel far{0.0, -1.0, 1.3, -0.2, 0.0, 0.0};
  const double at_antipode = det::indicatrix(far, M_PI);
  REQUIRE(at_antipode > 0.0);
  const model::LuminanceModel farther{0.0, -1.0, 5.3, -0.2, 0.0, 0.0};
  REQUIRE(det::indicatrix(farther, M_PI) < 0.0);
  REQUIRE(det::indicatrix(farther, M_PI / 2) > 0.0);
  CHECK_FALSE(model::whyUnusable(farther, zenith));
  CHECK(model::whyUnusable(farther, risingSun()));
}

TEST_CASE("IndicatrixTable, KeepsItsErrorAtEverySlopeAndAngle") {
  for (const double d : {-1e-6, -0.3, -1.0, -2.8, -3.0, -7.0, -16.0}) {
    const model::IndicatrixTable table(d);
    double worst = 0.0;
    for (int i = 0; i <= 100000; ++i) {
      const double angle = M_PI * i / 100000.0;
      const double s = std::sin(0.5 * angle);
      const double c = std::cos(0.5 * angle);
      worst = std::max(worst, std::abs(table.exponential(s * s, c * c) - std::exp(d * angle)));
    }
    CAPTURE(d, worst);
    CHECK(worst <= model::IndicatrixTable::kError);
    if (d < -0.5) CHECK(worst > 0.02 * model::IndicatrixTable::kError);  // no finer than it says
  }
}

}  // namespace
}  // namespace welkin::tests
