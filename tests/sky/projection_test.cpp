// SPDX-License-Identifier: Apache-2.0
// The quadrature against closed forms, a converged reference in other coordinates, and a brute-force sum.
#include "sky/model/projection.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "reference.h"
#include "sh/basis.h"

namespace welkin::tests {

using det::Number3;
namespace {

constexpr double kPromise = 1e-5;  // Relative to c0: the bake's bound for every coefficient.
constexpr double kElevations_deg[] = {90, 85, 60, 30, 10, 5, 1, 0, -1, -6, -18, -90};

model::Sky skyOf(const model::LuminanceModel& model, double sun_elevation_deg, double sun_azimuth_rad = 1.0) {
  model::Sky sky;
  sky.luminance = model;
  sky.sun.path.key_time_h = {0.0};
  sky.sun.path.key_azimuth_rad = {sun_azimuth_rad};
  sky.sun.path.key_elevation_rad = {sun_elevation_deg * M_PI / 180.0};
  return sky;
}

/// Largest difference of any coefficient and channel, in units of the channel's c0, and where.
double worst(const std::vector<Number3>& got, const std::vector<Number3>& want) {
  double largest = 0.0;
  for (std::size_t i = 0; i < got.size(); ++i)
    for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(got[i][c] - want[i][c]) / want[0][c]);
  return largest;
}

model::Gradient stripes(int width, int height, double phase, double darkest) {
  model::Gradient g{width, height, {}};
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i)
      for (int c = 0; c < 3; ++c)
        g.rgb.push_back(
            static_cast<float>(darkest + 0.5 + 0.5 * std::sin(phase + 1.7 * c + 2.3 * j + 0.9 * i * (c + 1))));
  return g;
}

TEST_CASE("Projection, UniformSkyClosedForm") {
  const model::Sky sky = skyOf(*model::findLuminance("cie-5"), 40.0);
  const auto m = model::SkyProjector(sky.luminance, 5).project(model::SkyInstant(sky, 0.0));
  const auto up = det::shBasis({0.0, 1.0, 0.0});
  for (int l = 0; l < 5; ++l)
    for (int k = -l; k <= l; ++k) {
      const auto i = static_cast<std::size_t>(sh::indexOf(l, k));
      // The upper hemisphere is the sphere less the lower one.
      const double want = (l == 0 ? std::sqrt(4.0 * M_PI) : 0.0) - det::groundLobe(l) * up.v[i];
      CAPTURE(l, k);
      CHECK(m.radiance_sh[i].y == Approx(want).margin(1e-6));
    }
  CHECK(m.radiance_sh[0].x == Approx(std::sqrt(M_PI)).epsilon(1e-7));
  CHECK(m.radiance_sh[1].x == Approx(std::sqrt(3.0 * M_PI) / 2.0).epsilon(1e-7));
  CHECK(m.horizontal_irradiance.x == Approx(M_PI).epsilon(1e-7));
}

TEST_CASE("Projection, CieOvercastClosedForm") {
  model::Sky sky = skyOf(*model::findLuminance("cie-overcast"), 25.0);
  sky.normalise_to_sun = false;
  const model::SkyInstant instant(sky, 0.0);
  const model::SkyProjector projector(sky.luminance, 3);
  CHECK(projector.project(instant).horizontal_irradiance.z == Approx(7.0 * M_PI / 9.0).epsilon(1e-8));
  const double vertical = projector.irradiance(instant, {0.0, 0.0, 1.0}).y;
  // Integral of (1 + 2 sin e)/3 cos^2 e cos a over the half in front: pi/6 + 4/9.
  CHECK(vertical == Approx(M_PI / 6.0 + 4.0 / 9.0).epsilon(1e-7));
  CHECK(vertical / (7.0 * M_PI / 9.0) == Approx(0.39618).margin(1e-5));
}

TEST_CASE("Projection, EveryModelAndSunElevationAgainstTheReference") {
  for (const auto& [name, model] : model::namedLuminances())
    for (const double elevation : kElevations_deg) {
      const model::Sky sky = skyOf(model, elevation);
      const model::SkyInstant instant(sky, 0.0);
      const auto want = referenceAboutSun(instant, 5);
      for (const double tolerance : {1e-4, 1e-5}) {
        const auto got = model::SkyProjector(sky.luminance, 5, tolerance).project(instant);
        CAPTURE(name, elevation, tolerance);
        CHECK(worst(got.radiance_sh, want.radiance_sh) < tolerance);
        CHECK(got.horizontal_irradiance.x == Approx(want.horizontal_irradiance.x).epsilon(tolerance));
      }
    }
}

TEST_CASE("Projection, KeepsEveryToleranceAtEverySunElevation") {
  // Elevations for which no panel was made. The finest rule is its own reference; the test above ties it to the other
  // one.
  for (const int bands : {2, 3, 5}) {
    double largest[3] = {};
    for (const auto& [name, model] : model::namedLuminances()) {
      const model::SkyProjector reference(model, bands, 1e-12);
      for (double elevation = -18.0; elevation < 90.0; elevation += 3.37) {
        const model::Sky sky = skyOf(model, elevation);
        const model::SkyInstant instant(sky, 0.0);
        const auto want = reference.project(instant).radiance_sh;
        for (int i = 0; i < 3; ++i) {
          const double tolerance = i == 0 ? 1e-4 : i == 1 ? 1e-5 : 1e-9;
          const double error =
              worst(model::SkyProjector(sky.luminance, bands, tolerance).project(instant).radiance_sh, want) /
              tolerance;
          CAPTURE(bands, name, elevation, tolerance);
          CHECK(error < 1.0);
          largest[i] = std::max(largest[i], error);
        }
      }
    }
    for (const double share : largest) CHECK(share > 0.02);  // and spends no more than needed
  }
}

TEST_CASE("Projection, NearDeltaSunAndSteepHorizon") {
  // The ends of the coefficients' range: a lobe of half a degree, and a layer of a hundredth of a degree.
  const model::LuminanceModel models[] = {{-1.0, -0.3, 2000.0, -120.0, 0.3, 0.0},
                                          {3.0, -2e-4, 24.0, -3.0, 0.3, 0.0},
                                          {-1.0, -30.0, 10.0, -0.1, 0.0, 0.0},
                                          {8.0, -5.0, 50.0, -20.0, 4.0, 0.0}};
  for (const auto& model : models)
    for (const double elevation : {80.0, 20.0, 2.0, 0.1, -0.2, -30.0}) {
      const model::Sky sky = skyOf(model, elevation);
      const model::SkyInstant instant(sky, 0.0);
      const model::SkyProjector projector(model, 5);
      const model::SkyProjector converged(model, 5, 1e-12);
      CAPTURE(model.a, model.b, model.c, model.d, elevation);
      CHECK(worst(projector.project(instant).radiance_sh, converged.project(instant).radiance_sh) < kPromise);
      if (elevation > 1.0)
        CHECK(worst(converged.project(instant).radiance_sh, referenceAboutSun(instant, 5).radiance_sh) < kPromise);
    }
}

TEST_CASE("Projection, ColouredGradientsAgainstBruteForce") {
  model::Sky sky = skyOf(*model::findLuminance("cie-12"), 35.0);
  sky.gradient_sun = stripes(5, 7, 0.3, 0.05);
  sky.gradient_anti = stripes(3, 4, 2.0, 0.05);
  model::normalise(sky.gradient_sun, sky.gradient_anti);
  for (const double time_h : {3.3, 12.0}) {
    const model::SkyInstant instant(sky, time_h);
    const auto got = model::SkyProjector(sky.luminance, 5).project(instant);
    // The midpoint rule's own error at this size, from half of it: below 2e-6.
    const auto want = referenceOverWorld(instant, 5, 600);
    CHECK(worst(got.radiance_sh, want.radiance_sh) < kPromise);
    CHECK(got.horizontal_irradiance.y == Approx(want.horizontal_irradiance.y).epsilon(kPromise));
  }
}

TEST_CASE("Projection, ColoursThatFadeToBlack") {
  // Texels far darker than the fade's luminance beside bright ones, so that the chromaticity bends inside the panels.
  model::Sky sky = skyOf(*model::findLuminance("cie-12"), 35.0);
  sky.gradient_sun = model::Gradient{1, 3, {1.0F, 0.4F, 0.2F, 0.0F, 0.0F, 0.0F, 0.2F, 0.3F, 0.9F}};
  sky.gradient_anti = model::Gradient{1, 2, {0.0F, 0.0F, 0.0F, 0.3F, 0.3F, 0.8F}};
  model::normalise(sky.gradient_sun, sky.gradient_anti);
  const model::SkyInstant instant(sky, 0.0);
  const auto got = model::SkyProjector(sky.luminance, 5).project(instant).radiance_sh;
  CHECK(worst(got, model::SkyProjector(sky.luminance, 5, 1e-12).project(instant).radiance_sh) < kPromise);
  constexpr double kMidpoint = 4e-5;  // the brute force's own error at this size: it falls by 2.7 at each doubling
  CHECK(worst(got, referenceOverWorld(instant, 5, 1400).radiance_sh) < kMidpoint);
}

TEST_CASE("Projection, TurnsWithTheSun") {
  model::Sky sky = skyOf(*model::findLuminance("far-cry-3"), 20.0, 0.4);
  sky.gradient_sun = stripes(1, 5, 0.3, 0.1);
  sky.gradient_anti = stripes(1, 3, 1.0, 0.1);
  model::Sky turned = sky;
  turned.sun.path.key_azimuth_rad = {0.4 + 1.3};
  const model::SkyProjector projector(sky.luminance, 5);
  const auto a = projector.project(model::SkyInstant(sky, 0.0)).radiance_sh;
  const auto b = projector.project(model::SkyInstant(turned, 0.0)).radiance_sh;
  const sh::Rotation rotation(5, sh::azimuthRotation(1.3));
  for (int c = 0; c < 3; ++c) {
    std::vector<double> in(25), out(25);
    for (std::size_t i = 0; i < 25; ++i) in[i] = a[i][c];
    rotation.apply(in, out);
    for (std::size_t i = 0; i < 25; ++i) CHECK(b[i][c] == Approx(out[i]).margin(1e-13 * a[0][c]));
  }
}

TEST_CASE("Projection, BrightSideIsTheSuns") {
  const model::Sky sky = skyOf(*model::findLuminance("cie-12"), 15.0, M_PI / 2);  // sun in the east, +x
  const auto c = model::SkyProjector(sky.luminance, 2).project(model::SkyInstant(sky, 0.0)).radiance_sh;
  CHECK(c[3].x > 0.3 * c[0].x);
  CHECK(std::abs(c[2].x) < 1e-12);
}

TEST_CASE("Irradiance, AgainstBruteForceForTiltedNormals") {
  constexpr double kMidpoint = 2e-5;  // the clipped cosine bends across the cells of the reference
  model::Sky sky = skyOf(*model::findLuminance("far-cry-3"), 12.0);
  sky.gradient_sun = stripes(4, 6, 0.3, 0.1);
  sky.gradient_anti = stripes(4, 5, 1.9, 0.1);
  model::normalise(sky.gradient_sun, sky.gradient_anti);
  const model::SkyInstant instant(sky, 7.0);
  const model::SkyProjector projector(sky.luminance, 1);
  const double up = projector.irradiance(instant, {0.0, 1.0, 0.0}).y;
  for (const Number3& n : {Number3(0, 1, 0), Number3(1, 0, 0), Number3(0.36, 0.48, 0.8), Number3(-0.6, -0.8, 0),
                           Number3(0.1, -0.7, std::sqrt(0.5)), Number3(0, 0.05, -std::sqrt(1 - 0.0025))}) {
    const auto got = projector.irradiance(instant, n);
    const auto want = referenceOverWorld(instant, 1, 600, n).horizontal_irradiance;
    for (int c = 0; c < 3; ++c) {
      CAPTURE(n.x, n.y, n.z, c);
      CHECK(got[c] == Approx(want[c]).margin(kMidpoint * up));
    }
  }
  CHECK(projector.irradiance(instant, {0, -1, 0}).x == Approx(0.0).margin(1e-12));
}

TEST_CASE("Irradiance, HalfOfAUniformSky") {
  const model::Sky sky = skyOf(*model::findLuminance("cie-5"), 40.0);
  const model::SkyInstant instant(sky, 0.0);
  for (const double y : {-0.9, -0.3, 0.0, 0.2, 0.7})
    CHECK(model::SkyProjector(sky.luminance, 1).irradiance(instant, {std::sqrt(1 - y * y), y, 0.0}).x ==
          Approx(M_PI * (1.0 + y) / 2.0).epsilon(2e-6).margin(1e-6));
}

}  // namespace
}  // namespace welkin::tests
