// SPDX-License-Identifier: Apache-2.0
// Position of a gradient's texels, the blend of colours over azimuth, and the effect of luminance.
#include "sky/model/gradient.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "sky/model/sky.h"

namespace welkin::tests {

using det::Number3;
namespace {

constexpr double kQuarter = M_PI / 2.0;

/// Red counts columns, green rows from the horizon.
model::Gradient counting(int width, int height) {
  model::Gradient g{width, height, {}};
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) g.rgb.insert(g.rgb.end(), {float(i), float(j), 1.0F});
  return g;
}

TEST_CASE("Gradient, TexelCentres") {
  const model::Gradient g = counting(4, 3);  // columns centred on 3, 9, 15, 21 h; rows on 15, 45, 75 degrees
  CHECK(model::columnAt(g, 9.0).at(kQuarter / 2).x == Approx(1.0));
  CHECK(model::columnAt(g, 12.0).at(kQuarter / 2).x == Approx(1.5));
  CHECK(model::columnAt(g, 9.0).at(kQuarter / 2).y == Approx(1.0));
  CHECK(model::columnAt(g, 9.0).at(kQuarter / 3).y == Approx(0.5));
  CHECK(model::columnAt(g, 9.0).at(0.0).y == 0.0);       // clamped below the first centre
  CHECK(model::columnAt(g, 9.0).at(kQuarter).y == 2.0);  // and above the last
}

TEST_CASE("Gradient, WrapsOverMidnight") {
  const model::Gradient g = counting(4, 1);
  CHECK(model::columnAt(g, 0.0).at(0.0).x == Approx(1.5));    // half way between column 3 and column 0
  CHECK(model::columnAt(g, 22.5).at(0.0).x == Approx(2.25));  // a quarter of the way
  CHECK(model::columnAt(g, 1.5).at(0.0).x == Approx(0.75));
  CHECK(model::columnAt(g, 23.999999).at(0.0).x == Approx(model::columnAt(g, 0.0).at(0.0).x).margin(1e-6));
  CHECK(model::columnAt(g, 26.0).at(0.0).x == Approx(model::columnAt(g, 2.0).at(0.0).x));
}

TEST_CASE("AzimuthWeight, SunSideOppositeAndZenith") {
  const auto sun = det::directionOf(0.7, 0.5);
  CHECK(det::azimuthWeight(det::directionOf(0.7, 0.2), sun) == Approx(1.0));
  CHECK(det::azimuthWeight(det::directionOf(0.7 + M_PI, 0.2), sun) == Approx(0.0).margin(1e-15));
  CHECK(det::azimuthWeight(det::directionOf(0.7 + M_PI / 3, 0.2), sun) == Approx(0.75));
  CHECK(det::azimuthWeight({0, 1, 0}, sun) == Approx(0.5));
  CHECK(det::azimuthWeight(det::directionOf(3.0, 0.2), {0, 1, 0}) == Approx(0.5));
  // Five degrees from the zenith the weight has faded by sin 5 / sin 10.
  const double faded = std::sin(5.0 * M_PI / 180.0) / std::sin(10.0 * M_PI / 180.0);
  CHECK(det::azimuthWeight(det::directionOf(0.7, 85.0 * M_PI / 180.0), sun) == Approx(0.5 + 0.5 * faded));
}

TEST_CASE("Chromaticity, LuminanceOneUnlessBlack") {
  for (const Number3& c : {Number3(1, 0, 0), Number3(0.2, 0.5, 0.9), Number3(1e-4, 2e-4, 1e-3)}) {
    const auto hue = det::chromaticity(c, 1e-4);
    CHECK(det::luminanceOf(hue) == Approx(1.0).epsilon(1e-14));
    CHECK(hue.x * c.z == Approx(hue.z * c.x).margin(1e-15));
  }
  CHECK(det::chromaticity({0, 0, 0}, 1e-4) == Number3(1.0));
  const auto dark = det::chromaticity({1e-5, 0, 0}, 1e-4);  // still luminance 1, on its way to neutral
  CHECK(det::luminanceOf(dark) == Approx(1.0).epsilon(1e-12));
  CHECK(dark.y > 0.9);
}

TEST_CASE("Desaturate, KeepsLuminance") {
  const Number3 c(0.9, 0.4, 0.1);
  CHECK(det::desaturate(c, 1.0).x == Approx(c.x));
  CHECK(det::desaturate(c, 0.0).x == Approx(det::luminanceOf(c)));
  CHECK(det::luminanceOf(det::desaturate(c, 0.3)) == Approx(det::luminanceOf(c)));
}

TEST_CASE("Normalise, BrightestLuminanceIsOneForAnyRange") {
  for (const float scale : {1e-30F, 1.0F, 1e30F}) {
    model::Gradient a{1, 1, {0.3F * scale, 0.2F * scale, 0.1F * scale}};
    model::Gradient b{1, 1, {scale, scale, scale}};
    model::normalise(a, b);
    CHECK(double{b.rgb[0]} == Approx(1.0).epsilon(1e-6));
    CHECK(double{a.rgb[0]} == Approx(0.3).epsilon(1e-6));
  }
  model::Gradient black{1, 1, {0, 0, 0}};
  model::Gradient other = black;
  model::normalise(black, other);
  CHECK(black.rgb[0] == 0.0F);
}

TEST_CASE("Gradient, SkyTakesColourOnlyFromIt") {
  model::Sky sky;
  sky.gradient_sun = model::Gradient::constant({0.9, 0.3, 0.1});
  sky.gradient_anti = model::Gradient::constant({0.1, 0.3, 0.9});
  model::normalise(sky.gradient_sun, sky.gradient_anti);
  sky.sun.path.key_time_h = {0.0};
  sky.sun.path.key_azimuth_rad = {0.0};
  sky.sun.path.key_elevation_rad = {0.6};
  const model::SkyInstant instant(sky, 5.0);
  for (const double azimuth : {0.0, 1.0, 3.0}) {
    const auto d = det::directionOf(azimuth, 0.3);
    CHECK(det::luminanceOf(instant.shape(d)) == Approx(instant.luminance(d)).epsilon(1e-13));
  }
  CHECK(instant.shape(det::directionOf(0.0, 0.3)).x > instant.shape(det::directionOf(0.0, 0.3)).z);
  CHECK(instant.shape(det::directionOf(M_PI, 0.3)).x < instant.shape(det::directionOf(M_PI, 0.3)).z);
}

}  // namespace
}  // namespace welkin::tests
