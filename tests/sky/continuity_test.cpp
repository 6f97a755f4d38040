// SPDX-License-Identifier: Apache-2.0
// Checks that nothing steps: in time through keys, midnight, sunset and the zenith; in direction across the zenith, the
// sun and its antipode. The days include one key, ten thousand keys, and two keys a second apart.
#include <limits>

#include "extreme_skies.h"

namespace welkin::tests {

using det::Number3;
namespace {

constexpr double kSecond_h = 1.0 / 3600.0;

/// The sun through the zenith at noon, the horizon at 6 h and 18 h, the nadir at midnight.
model::Sky equator(const model::LuminanceModel& model, bool to_sun) {
  model::Sky sky = coloured(model, to_sun);
  sky.sun.path = model::LightPath{};
  sky.moon->path = model::LightPath{};
  sky.moon->path.transit_h = 3.0;
  sky.intensity = {1, {0.0, 6.0, 18.5}, {0.01, 1.0, 2.0}};
  return sky;
}

Number3 load(const float (&v)[3], double factor = 1.0) {
  return Number3(double{v[0]}, double{v[1]}, double{v[2]}) * factor;
}

/// Results of the model and the runtime at a time, in three directions.
std::vector<Shown> shownAt(const model::Sky& model, const Baked& baked, double time_h) {
  const model::SkyInstant instant(model, time_h);
  WelkinSkySample sample{};
  REQUIRE(baked.sky.sample(time_h, sample));
  std::vector<Shown> values = {{load(sample.ground_radiance)}};
  for (const Number3& d : {Number3(0, 1, 0), Number3(0.6, 0.0, -0.8), Number3(-0.48, 0.6, 0.64)}) {
    values.push_back(domeOf(instant, d));
    const auto irradiance = seen(baked.sky, sample, d);
    values.insert(values.end(), irradiance.begin(), irradiance.end());
  }
  for (const WelkinLight* light : {&sample.sun, &sample.moon})
    values.push_back({load(light->normal_irradiance, double{light->visible})});
  return values;
}

}  // namespace

TEST_CASE("Continuity, NothingStepsInTime") {
  // A millisecond turns the sun by 7e-8 rad. The steepest change of a named model, in its own measure, is the gradation
  // of a sun on the horizon: 4 exp(-2) |a / b| per radian at b = -0.08. The indicatrix changes by 72 per radian. Both
  // are multiplied by the ratio of f at its least, so 1e3 in all, plus the error of floats.
  constexpr double kResolution_h = 1e-3 * kSecond_h;
  constexpr double kStep = 1e-4;
  for (const auto& [name, luminance] : model::namedLuminances())
    for (const bool to_sun : {true, false}) {
      const model::Sky model = equator(luminance, to_sun);
      const Baked baked(model, 3, std::vector<double>{0.0, 5.0, 5.0 + kSecond_h, 12.0, 23.999});
      const auto shown = [&](double time_h) { return shownAt(model, baked, time_h); };
      for (const double time_h : {0.0, 5.0, 6.0, 12.0, 18.0, 18.5, 23.999, 24.0})
        for (const double reach_h : {1e-5, 0.3}) {
          CAPTURE(name, to_sun, time_h, reach_h);
          CHECK(largestStep(shown, time_h - reach_h, time_h + 0.7 * reach_h, kResolution_h).height < kStep);
        }
    }
}

TEST_CASE("Continuity, NothingStepsWhereTheSunCrossesTheZenithBetweenKeys") {
  // The azimuth turns by half a turn at once, but the dependence on it that a coarse table keeps there must fade. In a
  // nanohour the sun moves 2.6e-10 rad. A fade over 1e-5 rad gives the bound, on both sides, plus the error of floats.
  constexpr double kNanohour = 1e-9;
  constexpr double kStep = 2.0 * 2.6e-5 + 2e-7;
  const model::Sky model = equator(*model::findLuminance("far-cry-3"), true);
  const Baked baked(model, 3, std::vector<double>{1.0, 9.0, 16.0});
  const auto at = [&](double time_h) {
    WelkinSkySample sample{};
    REQUIRE(baked.sky.sample(time_h, sample));
    return sample;
  };
  const auto before = at(12.0 - kNanohour);
  const auto after = at(12.0 + kNanohour);
  for (std::size_t i = 0; i < 9; ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      CAPTURE(i, c);
      CHECK(std::abs(double{after.ambient_sh[i][c]} - double{before.ambient_sh[i][c]}) <
            kStep * double{before.ambient_sh[0][c]});
    }
  CHECK(std::hypot(after.mode_azimuth[0], after.mode_azimuth[1]) < 3e-5F);
  const auto morning = at(9.0);
  CHECK(std::hypot(morning.mode_azimuth[0], morning.mode_azimuth[1]) == Approx(1.0F).epsilon(1e-6));
}

TEST_CASE("Continuity, AStepIsSeen") {
  // Confirms that the checks above detect a step: an intensity that falls within one unit of the last place of a time.
  model::Sky model = equator(*model::findLuminance("cie-12"), true);
  model.intensity = {1, {12.0, std::nextafter(12.0, 24.0)}, {1.0, 1.1}};
  const Baked baked(model, 2, std::vector<double>{0.0});
  const auto shown = [&](double time_h) { return shownAt(model, baked, time_h); };
  CHECK(largestStep(shown, 11.9, 12.2, 1e-3 * kSecond_h).height > 0.05);
}

TEST_CASE("Continuity, NothingStepsInDirection") {
  constexpr double kResolution_rad = 1e-6;  // a float direction near the sun steps by 6e-8
  constexpr double kStep = 1e-3;
  for (const auto& [name, luminance] : model::namedLuminances())
    for (const double elevation : {0.0, 40.0 * kDegree, 89.9999 * kDegree, 90.0 * kDegree, -20.0 * kDegree}) {
      model::Sky model = coloured(luminance, true);
      model.gradient_anti = model::Gradient{1, 2, {0.4F, 0.4F, 0.7F, 0.2F, 0.05F, 0.1F}};
      model.sun.path = still(0.4, elevation);
      const Baked baked(model, 3, std::vector<double>{0.0});
      const model::SkyInstant instant(model, 12.0);
      WelkinSkySample sample{};
      REQUIRE(baked.sky.sample(12.0, sample));
      const auto shown = [&](const Number3& d) {
        auto values = seen(baked.sky, sample, d);
        values.push_back(domeOf(instant, d));
        return values;
      };
      for (const double azimuth : {0.4, 0.4 + 1e-9, 1.3, 2.9}) {
        CAPTURE(name, elevation, azimuth);
        // Over the zenith, from one horizon to the other; and around the compass.
        CHECK(largestStep([&](double e) { return shown(det::directionOf(azimuth, e)); }, 1e-9, det::kPi - 1e-9,
                          kResolution_rad)
                  .height < kStep);
        for (const double height : {0.01, 1.0, 1.5707})
          CHECK(largestStep([&](double a) { return shown(det::directionOf(a, height)); }, azimuth, azimuth + 6.0,
                            kResolution_rad)
                    .height < kStep);
      }
    }
}

TEST_CASE("Continuity, ColoursFadeToNeutralWithoutAStep") {
  // Beside a black texel the hue changes as 1 / luminance, down to kGradientDelta. The change is up to 1 / 1e-4 of a
  // texel's difference, over half of 45 degrees.
  constexpr double kResolution_rad = 1e-10;
  model::Sky model = coloured(*model::findLuminance("cie-5"), true);
  model.sun.path = still(0.4, 0.0);
  const model::SkyInstant instant(model, 12.0);
  for (const double azimuth : {0.4, 2.0, 3.5415926535897931})
    CHECK(largestStep(
              [&](double e) { return std::vector<Shown>{{instant.dome(det::directionOf(azimuth, e), Number3(0.0))}}; },
              1e-9, det::kHalfPi, kResolution_rad)
              .height < 1e5 * kResolution_rad);
}

TEST_CASE("Days, OneKeyTenThousandKeysAndTwoASecondApart") {
  const model::Sky model = equator(*model::findLuminance("cie-12"), true);
  const double last = std::nextafter(24.0, 0.0);
  const std::vector<std::vector<double>> days = {{0.0},
                                                 {last},
                                                 {13.0},
                                                 {0.0, last},
                                                 {12.0, 12.0 + kSecond_h},
                                                 {0.0, kSecond_h},
                                                 {24.0 - kSecond_h, last},
                                                 {0.0, std::numeric_limits<double>::denorm_min()},
                                                 {6.0, std::nextafter(6.0, 7.0)}};
  for (const auto& keys : days) {
    const Baked baked(model, 2, keys);
    for (const double key : keys)
      for (const double time_h : {key, std::nextafter(key, 25.0), std::nextafter(key, -1.0), key + 12.0, key - 1e-300})
        holds(model, baked, time_h);
    for (const double time_h : {-0.0, 24.0, -24.0, 1e300, -1e300, 1e-320}) {
      WelkinSkySample sample{};
      REQUIRE(baked.sky.sample(time_h, sample));
      CHECK(faultOfSample(sample).empty());
    }
  }
}

TEST_CASE("Days, TenThousandKeysFollowTheModel") {
  // The sun moves 6.3e-4 rad between keys; linear interpolation leaves an eighth of the second derivative's share.
  constexpr double kLinear = 1e-5;
  model::Sky model = equator(*model::findLuminance("cie-3"), true);
  model.gradient_sun = model::Gradient();
  model.gradient_anti = model::Gradient();
  model.ground_albedo = Number3(0.0);
  model.intensity = base::Curve::constant(1.0);
  const Baked baked(model, 2, 10000);
  REQUIRE(baked.sky.info().key_count == 10000);
  for (int i = 0; i < 10000; i += 773) {
    const double time_h = 24.0 * (i + 0.5) / 10000.0;
    holds(model, baked, time_h);
    WelkinSkySample sample{};
    REQUIRE(baked.sky.sample(time_h, sample));
    const model::SkyMoments exact = model::SkyProjector(model.luminance, 2).project(model::SkyInstant(model, time_h));
    for (std::size_t k = 0; k < 4; ++k)
      CHECK(double{sample.radiance_sh[k][0]} ==
            Approx(exact.radiance_sh[k].x).margin((kLinear + model::kTolerance) * exact.radiance_sh[0].x));
  }
}

}  // namespace welkin::tests
