// SPDX-License-Identifier: Apache-2.0
// The whole day: properties that hold at every sun elevation, time and direction, and the table against the model.
#include <catch2/catch.hpp>
#include <cmath>

#include "baked.h"
#include "degree.h"

namespace welkin::tests {

using det::Number3;
namespace {

/// The sun covers the whole range: the zenith at noon, the nadir at midnight.
model::Sky equatorSky(const model::LuminanceModel& model, bool to_sun) {
  model::Sky sky;
  sky.luminance = model;
  sky.normalise_to_sun = to_sun;
  sky.sun.path.latitude_rad = 0.0;
  sky.sun.path.declination_rad = 0.0;
  sky.gradient_sun = model::Gradient{2, 2, {1.0F, 0.4F, 0.1F, 0.2F, 0.3F, 0.5F, 0.3F, 0.4F, 0.9F, 0.1F, 0.2F, 0.6F}};
  sky.gradient_anti = model::Gradient{2, 1, {0.4F, 0.4F, 0.7F, 0.1F, 0.1F, 0.4F}};
  model::normalise(sky.gradient_sun, sky.gradient_anti);
  return sky;
}

std::vector<Number3> directions() {
  std::vector<Number3> list = {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}, {0, -1, 0}, {0, 1e-300, 1}, {0, -1e-300, 1}};
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 12; ++j) list.push_back(det::directionOf(0.53 * j, (i + 0.1) * 11.0 * kDegree));
  return list;
}

TEST_CASE("Day, RadianceIsFiniteAndNonNegativeForEveryModel") {
  int looks = 0;  // Counted instead of asserted: millions of assertions would take most of the time.
  for (const auto& [name, model] : model::namedLuminances())
    for (const bool to_sun : {true, false}) {
      const model::Sky sky = equatorSky(model, to_sun);
      for (double time = 0.0; time < 24.0; time += 0.0831) {
        const model::SkyInstant instant(sky, time);
        auto looked = directions();
        looked.push_back(instant.sunDirection());
        looked.push_back(-instant.sunDirection());
        for (const Number3& d : looked) {
          const Number3 r = instant.shape(d);
          ++looks;
          if (std::min({r.x, r.y, r.z}) >= 0.0 && std::isfinite(r.x + r.y + r.z)) continue;
          CAPTURE(name, to_sun, time, d.x, d.y, d.z, r.x, r.y, r.z);
          FAIL("radiance that is negative or not finite");
        }
      }
    }
  REQUIRE(looks > 1000000);
}

TEST_CASE("Day, ContinuousThroughSunsetZenithAndMidnight") {
  // A tenth of a second moves the sun by 4e-4 degrees: nothing may step.
  constexpr double kStep_h = 0.1 / 3600.0;
  for (const auto& [name, model] : model::namedLuminances()) {
    const model::Sky sky = equatorSky(model, true);
    for (const double time : {0.0, 6.0, 12.0, 18.0, 3.0, 24.0 - kStep_h / 2}) {
      const model::SkyInstant before(sky, time - kStep_h / 2);
      const model::SkyInstant after(sky, time + kStep_h / 2);
      for (const Number3& d : directions())
        for (int c = 0; c < 3; ++c) {
          CAPTURE(name, time, d.x, d.y, d.z, c);
          // Slope bound: the gradation of the sun's elevation changes fastest, by |b| / sin^2 e near the horizon.
          REQUIRE(after.shape(d)[c] == Approx(before.shape(d)[c]).epsilon(2e-3));
        }
    }
  }
}

TEST_CASE("Day, ContinuousInDirectionAtTheZenith") {
  const model::Sky sky = equatorSky(*model::findLuminance("far-cry-3"), true);
  const model::SkyInstant instant(sky, 8.0);
  const Number3 zenith = instant.shape({0, 1, 0});
  for (double azimuth = 0.0; azimuth < 6.2; azimuth += 0.3)
    for (int c = 0; c < 3; ++c)
      CHECK(instant.shape(det::directionOf(azimuth, M_PI / 2 - 1e-7))[c] == Approx(zenith[c]).epsilon(1e-5));
}

TEST_CASE("Day, TurningTheSunTurnsEverything") {
  constexpr double kTurn = 1.1;
  model::Sky sky = equatorSky(*model::findLuminance("far-cry-3"), true);
  sky.sun.path = model::LightPath{};
  sky.sun.path.key_time_h = {0.0};
  sky.sun.path.key_azimuth_rad = {0.4};
  sky.sun.path.key_elevation_rad = {0.5};
  model::Sky turned = sky;
  turned.sun.path.key_azimuth_rad = {0.4 + kTurn};
  const model::SkyInstant a(sky, 8.0);
  const model::SkyInstant b(turned, 8.0);
  const model::SkyProjector projector(sky.luminance, 2);
  for (double azimuth = 0.0; azimuth < 6.0; azimuth += 0.7)
    for (const double elevation : {0.0, 0.3, 1.2}) {
      const Number3 before = a.shape(det::directionOf(azimuth, elevation));
      const Number3 after = b.shape(det::directionOf(azimuth + kTurn, elevation));
      const Number3 e_before = projector.irradiance(a, det::directionOf(azimuth, elevation - 0.4));
      const Number3 e_after = projector.irradiance(b, det::directionOf(azimuth + kTurn, elevation - 0.4));
      for (int c = 0; c < 3; ++c) {
        CAPTURE(azimuth, elevation, c);
        CHECK(after[c] == Approx(before[c]).epsilon(1e-12));
        CHECK(e_after[c] == Approx(e_before[c]).epsilon(1e-8));  // the panels meet the clipped cosine elsewhere
      }
    }
}

TEST_CASE("Runtime, TableAtItsKeysIsTheModel") {
  constexpr double kFloat = 3e-7;  // the table's floats, of c0
  model::Sky model = equatorSky(*model::findLuminance("cie-12"), true);
  model.intensity = {1, {6.0, 12.0}, {0.5, 2.0}};
  model.ground_albedo = Number3(0.3, 0.2, 0.1);
  model.ambient_saturation = base::Curve::constant(0.4);
  model.sun.illuminance = base::Curve::constant(2.0);
  model.sun.colour = base::Curve::constant(Number3(1.0, 0.8, 0.6));
  const Baked baked(model, 5, 24);
  for (int hour = 0; hour < 24; ++hour) {
    const model::SkyInstant instant(model, hour);
    const auto moments = model::SkyProjector(instant.sky().luminance, 5).project(instant);
    const Number3 ground = instant.groundRadiance(moments.horizontal_irradiance);
    const auto up = det::shBasis({0, 1, 0});
    WelkinSkySample s;
    REQUIRE(baked.sky.sample(hour, s));
    for (int c = 0; c < 3; ++c) CHECK(double{s.ground_radiance[c]} == Approx(ground[c]).epsilon(1e-6));
    for (std::size_t i = 0; i < 25; ++i) {
      const int band = i < 1 ? 0 : i < 4 ? 1 : i < 9 ? 2 : i < 16 ? 3 : 4;
      const Number3 radiance =
          moments.radiance_sh[i] * instant.intensity() + ground * (det::groundLobe(band) * up.v[i]);
      const Number3 ambient = det::desaturate(radiance, 0.4);
      for (int c = 0; c < 3; ++c) {
        CAPTURE(hour, i, c);
        const double scale = moments.radiance_sh[0][c] * instant.intensity() + ground[c];
        CHECK(double{s.radiance_sh[i][c]} == Approx(radiance[c]).margin(kFloat * scale));
        CHECK(double{s.ambient_sh[i][c]} == Approx(ambient[c]).margin(5 * kFloat * scale));
      }
    }
  }
}

TEST_CASE("Runtime, LightsStandWhereTheModelHasThem") {
  constexpr double kFloat = 1e-7;
  model::Sky model = equatorSky(*model::findLuminance("cie-12"), true);
  model.sun.path = model::sunPathFromPlace(48.0, 11.0, 3.0, 2020, 100);
  model.sun.path.north_offset_rad = 0.3;
  model.moon.emplace();
  model.moon->path.key_time_h = {1.0, 9.0, 20.0};
  model.moon->path.key_azimuth_rad = {6.0, 1.0, 3.0};
  model.moon->path.key_elevation_rad = {0.5, -0.4, 1.1};
  const Baked baked(model, 2, 2);
  for (double time_h = 0.0; time_h < 24.0; time_h += 0.37) {
    WelkinSkySample s;
    REQUIRE(baked.sky.sample(time_h, s));
    const Number3 sun = model.sun.path.directionAt(time_h);
    const Number3 moon = model.moon->path.directionAt(time_h);
    CAPTURE(time_h);
    for (int c = 0; c < 3; ++c) {
      CHECK(double{s.sun.direction[c]} == Approx(sun[c]).margin(kFloat));
      CHECK(double{s.moon.direction[c]} == Approx(moon[c]).margin(kFloat));
    }
  }
}

TEST_CASE("Runtime, BlendsBetweenKeysAndOverMidnight") {
  const model::Sky model = equatorSky(*model::findLuminance("cie-12"), false);
  const Baked baked(model, 2, 4);
  WelkinSkySample a, b, middle, wrapped;
  REQUIRE(baked.sky.sample(18.0, a));
  REQUIRE(baked.sky.sample(0.0, b));
  REQUIRE(baked.sky.sample(22.5, middle));
  REQUIRE(baked.sky.sample(22.5 + 48.0, wrapped));
  for (std::size_t i = 0; i < 4; ++i)
    CHECK(double{middle.radiance_sh[i][0]} ==
          Approx(0.25 * double{a.radiance_sh[i][0]} + 0.75 * double{b.radiance_sh[i][0]}).margin(1e-6));
  CHECK(wrapped.radiance_sh[1][0] == middle.radiance_sh[1][0]);
  CHECK(wrapped.time_h == 22.5);
  WelkinSkySample untouched{};
  CHECK_FALSE(baked.sky.sample(NAN, untouched));
  CHECK_FALSE(baked.sky.sample(INFINITY, untouched));
}

TEST_CASE("Runtime, DomeIsTheModel") {
  constexpr double kFloat = 5e-6;  // float sun, norm and gradients; the indicatrix amplifies the sun's by |d|
  model::Sky model = equatorSky(*model::findLuminance("far-cry-3"), true);
  model.polarising_tint = base::Curve::constant(Number3(0.7, 0.8, 0.9));
  model.intensity = base::Curve::constant(1.7);
  const Baked baked(model, 2, 8);
  for (const double time : {0.3, 5.9, 6.0, 6.1, 9.0, 12.0, 17.2, 18.3, 23.99}) {
    WelkinSkySample s;
    REQUIRE(baked.sky.sample(time, s));
    const model::SkyInstant instant(model, time);
    for (const Number3& d : directions()) {
      const float f[3] = {float(d.x), float(d.y), float(d.z)};
      float got[3];
      REQUIRE(welkin_dome_radiance(baked.sky.get(), &s, f, got) == WELKIN_OK);
      const Number3 seen(double{f[0]}, double{f[1]}, double{f[2]});
      const Number3 want = instant.dome(seen, Number3(0.0));
      for (int c = 0; c < 3; ++c) {
        CAPTURE(time, d.x, d.y, d.z, c);
        CHECK(double{got[c]} == Approx(want[c]).epsilon(kFloat).margin(1e-12));
      }
    }
  }
}

TEST_CASE("Runtime, IrradianceOfTheTable") {
  // Uniform sky over a ground of albedo 1: closed form pi ((1 + n_y)/2 + (1 - n_y)/2 E/pi).
  model::Sky model;
  model.luminance = *model::findLuminance("cie-5");
  model.sun.path.key_time_h = {0.0};
  model.sun.path.key_azimuth_rad = {0.0};
  model.sun.path.key_elevation_rad = {0.5};
  model.ground_albedo = Number3(1.0);
  const Baked baked(model, 3, 1);
  WelkinSkySample s;
  REQUIRE(baked.sky.sample(3.0, s));
  for (const float y : {1.0F, 0.6F, 0.0F, -1.0F}) {
    const float n[3] = {std::sqrt(1.0F - y * y), y, 0.0F};
    float e[3];
    REQUIRE(welkin_sample_irradiance(&s, n, e) == WELKIN_OK);
    CHECK(double{e[0]} == Approx(M_PI).epsilon(1e-5));  // the furnace
  }
  model.ground_albedo = Number3(0.0);
  const Baked black(model, 3, 1);
  REQUIRE(black.sky.sample(3.0, s));
  for (const float y : {1.0F, 0.6F, 0.0F, -0.5F}) {
    const float n[3] = {0.0F, y, std::sqrt(1.0F - y * y)};
    float e[3];
    REQUIRE(welkin_sample_irradiance(&s, n, e) == WELKIN_OK);
    CHECK(double{e[1]} == Approx(M_PI * (1.0 + double{y}) / 2.0).epsilon(1e-5));
  }
}

TEST_CASE("Runtime, AutoKeysFollowTheModel") {
  // Cost of five minutes between keys, relative to c0, at the worst instant between keys.
  const model::Sky model = equatorSky(*model::findLuminance("cie-12"), false);
  const Baked baked(model, 3, bake::kAutoKeys);
  double largest = 0.0;
  for (double time = 2.5 / 60.0; time < 24.0; time += 5.0 / 60.0) {
    WelkinSkySample s;
    REQUIRE(baked.sky.sample(time, s));
    const auto moments = model::SkyProjector(model.luminance, 3).project(model::SkyInstant(model, time));
    for (std::size_t i = 0; i < 9; ++i)
      largest = std::max(largest,
                         std::abs(double{s.radiance_sh[i][1]} - moments.radiance_sh[i].y) / moments.radiance_sh[0].y);
  }
  CHECK(largest < 0.01);
  CHECK(largest > 1e-6);  // a difference was measured
}

}  // namespace
}  // namespace welkin::tests
