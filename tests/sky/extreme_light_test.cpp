// SPDX-License-Identifier: Apache-2.0
// Gradients and intensities at the ends of their domain, and skies of known light: constant, black, near-delta.
#include <limits>

#include "extreme_skies.h"
#include "reference.h"

namespace welkin::tests {

using det::Number3;
namespace {

constexpr float kLargest = std::numeric_limits<float>::max();
constexpr float kUnit = std::numeric_limits<float>::denorm_min();

Number3 irradianceOf(const WelkinSkySample& sample, const Number3& normal) {
  const float n[3] = {float(normal.x), float(normal.y), float(normal.z)};
  float e[3];
  REQUIRE(welkin_sample_irradiance(&sample, n, e) == WELKIN_OK);
  return {double{e[0]}, double{e[1]}, double{e[2]}};
}

}  // namespace

TEST_CASE("Extremes, GradientsBlackOfOneTexelAndOverTheWholeRange") {
  const model::Gradient gradients[] = {
      model::Gradient::constant(Number3(0.0)),                            // black
      model::Gradient::constant(Number3(1e-30)),                          // a single texel
      model::Gradient::constant(Number3(0.0, 0.0, 1e30)),                 // of one primary
      {2, 2, {1e-30F, 0, 0, 0, 1e30F, 0, 0, 0, 0, 1e30F, 1e30F, 1e30F}},  // 60 orders beside each other
      {3, 3, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}},  // one among black
      {1, 2, {kUnit, 0, 0, 0, 0, kUnit}},
      {2, 1, {kLargest, kLargest, kLargest, 0, 0, 0}},
      {1, 1, {0, 0, kLargest}},
      {1, 3, {1, 1, 1, 1e-4F, 1e-4F, 1e-4F, 0.99e-4F, 1.01e-4F, 1e-4F}}};  // about the luminance where colours fade
  for (const model::Gradient& at_sun : gradients)
    for (const model::Gradient& opposite : gradients)
      for (const double elevation : {0.5, 0.0, -0.3, det::kHalfPi}) {
        model::Sky model = coloured(*model::findLuminance("far-cry-3"), true);
        model.sun.path = still(0.7, elevation);
        model.gradient_sun = at_sun;
        model.gradient_anti = opposite;
        model::normalise(model.gradient_sun, model.gradient_anti);
        CAPTURE(at_sun.rgb, opposite.rgb, elevation);
        const Baked baked(model, 3, std::vector<double>{0.0});
        for (const double time_h : {0.0, 3.0, 6.0, 12.0, 23.999999}) holds(model, baked, time_h);
      }
}

TEST_CASE("Extremes, ABakeKeepsItsToleranceBesideDarkTexels") {
  // From a red to a blue whose luminance is lower by a ratio, in both directions over elevation and over azimuth.
  constexpr double kBruteForce = 1e-4;  // of c0, of the midpoint rule below
  double largest = 0.0;
  for (const double ratio : {1.0, 3.9, 8.0, 15.0, 30.0, 100.0, 1e3, 9.9e3, 1.01e4, 1e5, 1e30})
    for (int way = 0; way < 4; ++way) {
      const std::vector<float> red = {1.0F, 0.0F, 0.0F};
      const std::vector<float> blue = {0.0F, 0.0F, static_cast<float>(0.2126 / 0.0722 / ratio)};
      const std::vector<float>& low = way % 2 == 0 ? red : blue;
      const std::vector<float>& high = way % 2 == 0 ? blue : red;
      std::vector<float> both = low;
      both.insert(both.end(), high.begin(), high.end());
      model::Sky model;
      model.luminance = *model::findLuminance("cie-12");
      model.sun.path = still(0.3, 0.5);
      model.gradient_sun = way < 2 ? model::Gradient{1, 2, both} : model::Gradient{1, 1, low};
      model.gradient_anti = way < 2 ? model::Gradient{1, 2, both} : model::Gradient{1, 1, high};
      model::normalise(model.gradient_sun, model.gradient_anti);
      const model::SkyInstant instant(model, 0.0);
      const model::SkyMoments bake = model::SkyProjector(model.luminance, 3).project(instant);
      const model::SkyMoments finest = model::SkyProjector(model.luminance, 3, 1e-12).project(instant);
      double c0 = 0.0;
      double error = 0.0;
      for (int c = 0; c < 3; ++c) c0 = std::max(c0, finest.radiance_sh[0][c]);
      for (std::size_t i = 0; i < finest.radiance_sh.size(); ++i)
        for (int c = 0; c < 3; ++c)
          error = std::max(error, std::abs(bake.radiance_sh[i][c] - finest.radiance_sh[i][c]) / c0);
      CAPTURE(ratio, way);
      CHECK(error < model::kTolerance);
      largest = std::max(largest, error);
      if (ratio != 30.0) continue;
      const Reference reference = referenceOverWorld(instant, 3, 400);
      for (std::size_t i = 0; i < finest.radiance_sh.size(); ++i)
        for (int c = 0; c < 3; ++c)
          CHECK(finest.radiance_sh[i][c] == Approx(reference.radiance_sh[i][c]).margin(kBruteForce * c0));
    }
  CHECK(largest > 1e-8);  // a difference was measured
}

TEST_CASE("Extremes, IntensitiesFromDenormalsToPastFloat") {
  // The last is about the brightest model that the loader accepts: 2e17 times the zenith on the horizon, from factors
  // of 2e-9.
  const model::LuminanceModel brightest{-1.0, -2e-9, 0.0, -1.0, 2e-9 - 1.0, 0.0};
  for (const model::LuminanceModel& m : {*model::findLuminance("cie-5"), *model::findLuminance("far-cry-3"), brightest})
    for (const bool to_sun : {true, false})
      for (const double intensity : {0.0, 4.9e-324, 1e-310, 1e-45, 1e-38, 65504.0, 65505.0, 1e12})
        for (const double tint : {0.0, 1e-12, 1e12}) {
          model::Sky model = coloured(m, to_sun);
          model.sun.path = still(2.0, det::kHalfPi);
          REQUIRE_FALSE(model::whyUnusable(m, model.sun.path));
          model.intensity = base::Curve::constant(intensity);
          model.polarising_tint = base::Curve::constant(Number3(tint, 1.0, tint));
          model.sun.illuminance = base::Curve::constant(1e12);
          model.sun.colour = base::Curve::constant(Number3(1e12, 0.0, 1e-12));
          model.sun.disc_radius_rad = 1e-9;
          CAPTURE(m.a, to_sun, intensity, tint);
          const Baked baked(model, 5, std::vector<double>{0.0});
          holds(model, baked, 13.0);
          WelkinSkySample sample{};
          REQUIRE(baked.sky.sample(13.0, sample));
          if (intensity > 1e-30) CHECK(irradianceOf(sample, {0, 1, 0}).y > 0.0);
          if (m.a != brightest.a || m.b != brightest.b || to_sun || intensity < 1e12 || tint < 1.0) continue;
          CHECK(seen(baked.sky, sample, {1, 0, 0})[0].colour.x == double{kLargest});  // past it: the largest
        }
}

TEST_CASE("Extremes, ABlackSkyIsExactlyBlack") {
  model::Sky model = coloured(*model::findLuminance("cie-12"), true);
  model.intensity = base::Curve::constant(0.0);
  model.sun.illuminance = base::Curve::constant(0.0);
  model.moon.reset();
  model.sun.path = still(0.0, 0.4);
  const Baked baked(model, 5, 3);
  WelkinSkySample sample{};
  for (const double time_h : {0.0, 8.0, 20.0}) {
    REQUIRE(baked.sky.sample(time_h, sample));
    for (const Number3& d : specialDirections({0, 0.6, 0.8}))
      for (const Shown& shown : seen(baked.sky, sample, d)) CHECK(shown.colour == Number3(0.0));
  }
}

TEST_CASE("Extremes, AConstantSkyLightsByItsClosedForm") {
  // Radiance L over a ground of albedo rho: E(n) = pi L ((1 + n_y)/2 + rho (1 - n_y)/2), exact in 2, 4 and 5 bands.
  model::Sky model;
  model.luminance = *model::findLuminance("cie-5");
  model.sun.path = still(0.3, 0.2);
  model.ground_albedo = Number3(0.2, 0.5, 1.0);
  for (const double radiance : {1e-30, 1e-12, 1.0, 1e12}) {
    model.intensity = base::Curve::constant(radiance);
    const Baked baked(model, 5, std::vector<double>{0.0});
    WelkinSkySample sample{};
    REQUIRE(baked.sky.sample(1.0, sample));
    for (const Number3& n : specialDirections({0, 0.6, 0.8})) {
      const Number3 e = irradianceOf(sample, n);
      for (int c = 0; c < 3; ++c)
        CHECK(e[c] / radiance ==
              Approx(M_PI * ((1.0 + n.y) / 2.0 + model.ground_albedo[c] * (1.0 - n.y) / 2.0)).margin(2e-5));
    }
  }
}

TEST_CASE("Extremes, ANearDeltaSkyLightsAsItsLobe") {
  // The steepest lobe that outshines the rest. For a surface that faces it, E is the result of 5 bands for a delta of
  // that power: sum over l of A_l (2 l + 1) / 4 pi.
  model::Sky model;
  model.luminance = {0.0, -1.0, 1e4, -100.0, 0.0, 0.0};
  model.normalise_to_sun = false;
  model.sun.path = still(0.3, 0.8);
  const Baked baked(model, 5, std::vector<double>{0.0});
  WelkinSkySample sample{};
  REQUIRE(baked.sky.sample(1.0, sample));
  const double norm = model::SkyInstant(model, 1.0).luminanceNorm();
  const double power = 1e4 * 2.0 * M_PI / (1.0 + 100.0 * 100.0) / norm;
  const double uniform = M_PI * (1.0 + std::sin(0.8)) / 2.0 / norm;
  double share = 0.0;
  for (int l = 0; l < 5; ++l) share += det::cosineLobe(l) * (2 * l + 1) / (4.0 * M_PI);
  const Number3 sun = model.sun.path.directionAt(1.0);
  constexpr double kWidth = 2e-3;    // The lobe's width, 1/100, blurs band l by about l (l + 1) / (2 100^2).
  constexpr double kUniform = 0.03;  // Share of the uniform hemisphere's irradiance outside of 5 bands.
  CHECK(irradianceOf(sample, sun).x == Approx(power * share + uniform).margin(kWidth * power + kUniform * uniform));
}

}  // namespace welkin::tests
