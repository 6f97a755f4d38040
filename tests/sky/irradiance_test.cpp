// SPDX-License-Identifier: Apache-2.0
// Irradiance of all normals at once against direct integration for each normal.
#include "sky/model/irradiance.h"

#include <tbb/parallel_for.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <mutex>

#include "degree.h"

namespace welkin::tests {

using det::Number3;
namespace {

/// A sky whose sun stands at an elevation, azimuth 40 degrees.
model::Sky fixedSky(const model::LuminanceModel& model, double elevation_deg) {
  model::Sky sky;
  sky.luminance = model;
  sky.sun.path.key_time_h = {0.0};
  sky.sun.path.key_azimuth_rad = {40.0 * kDegree};
  sky.sun.path.key_elevation_rad = {elevation_deg * kDegree};
  return sky;
}

/// World direction of a normal with a row's y, at an azimuth from the sun's. The sign selects the side.
Number3 normalAt(double y, double alpha) {
  const double across = std::sqrt(std::max(1.0 - y * y, 0.0));
  const double azimuth = 40.0 * kDegree + alpha;
  return {across * std::sin(azimuth), y, -across * std::cos(azimuth)};
}

Number3 valueOf(const model::IrradianceField& field, int row, double alpha) {
  Number3 sum(0.0);
  for (int m = 0; m < model::IrradianceProjector::kOrders; ++m)
    sum += field.series[static_cast<std::size_t>(row * model::IrradianceProjector::kOrders + m)] * std::cos(m * alpha);
  return sum;
}

/// Largest difference of any channel over the mean, at every `stride`-th row and some azimuths on both sides.
double worstOf(const model::Sky& sky, int stride, const model::IrradianceRule& rule = model::kIrradianceRules[0]) {
  const model::SkyInstant instant(sky, 0.0);
  const model::IrradianceProjector projector(sky.luminance, rule);
  const model::IrradianceField field = projector.fieldOf(instant);
  const model::SkyProjector direct(sky.luminance, 1, 1e-9);
  double worst = 0.0;
  for (int row = 0; row < model::IrradianceProjector::kRows; row += stride)
    for (const double alpha : {0.0, -1.1, 0.5 * M_PI, M_PI}) {
      const Number3 up = normalAt(projector.rowY(row), alpha);
      const Number3 above = valueOf(field, row, alpha);
      const Number3 below = above - field.excess(projector.rowY(row), std::cos(alpha));
      const Number3 want_above = direct.irradiance(instant, up);
      const Number3 want_below = direct.irradiance(instant, -up);
      for (int c = 0; c < 3; ++c) {
        worst = std::max(worst, std::abs(above[c] - want_above[c]) / field.mean[c]);
        worst = std::max(worst, std::abs(below[c] - want_below[c]) / field.mean[c]);
      }
    }
  return worst;
}

}  // namespace

TEST_CASE("IrradianceField, IsDirectIntegrationForEveryModelAndSun") {
  const auto& named = model::namedLuminances();
  const double elevations[] = {-18.0, 0.0, 2.0, 12.0, 50.0, 90.0};
  double worst = 0.0;
  std::string where;
  std::mutex mutex;
  tbb::parallel_for(std::size_t{0}, named.size() * std::size(elevations), [&](std::size_t i) {
    const auto& [name, model] = named[i / std::size(elevations)];
    const double elevation = elevations[i % std::size(elevations)];
    const double here = worstOf(fixedSky(model, elevation), 16);
    const std::lock_guard lock(mutex);
    if (here > worst) {
      worst = here;
      where = std::string(name) + " at " + std::to_string(elevation);
    }
  });
  CAPTURE(where, worst);
  CHECK(worst < model::IrradianceProjector::kError);
  CHECK(worst > model::IrradianceProjector::kError / 1.2);
}

TEST_CASE("IrradianceField, CoarserRulesKeepTheirErrors") {
  for (std::size_t i = 1; i < std::size(model::kIrradianceRules); ++i) {
    const model::IrradianceRule& rule = model::kIrradianceRules[i];
    double worst = 0.0;
    for (const auto& [name, model] : model::namedLuminances())
      for (const double elevation : {-18.0, 0.0, 2.0, 12.0, 50.0, 90.0}) {
        const model::Sky sky = fixedSky(model, elevation);
        const model::SkyInstant instant(sky, 0.0);
        const model::IrradianceField coarse = model::IrradianceProjector(model, rule).fieldOf(instant);
        const model::IrradianceField fine = model::IrradianceProjector(model, {48, 0.0}).fieldOf(instant);
        for (int row = 0; row < model::IrradianceProjector::kRows; ++row)
          for (const double alpha : {0.0, 0.5, 1.1, 0.5 * M_PI, 2.2, M_PI})
            worst =
                std::max(worst, std::abs(valueOf(coarse, row, alpha).x - valueOf(fine, row, alpha).x) / fine.mean.x);
      }
    CAPTURE(rule.panels, worst);
    CHECK(worst < rule.error);
    CHECK(worst > rule.error / 1.2);
  }
}

TEST_CASE("IrradianceField, ARuleIsTheLeastWorkWithinAnError") {
  CHECK(model::irradianceRuleFor(1.0).panels == 2);
  CHECK(model::irradianceRuleFor(1e-3).panels == 2);
  CHECK(model::irradianceRuleFor(0.9e-3).panels == 4);
  CHECK(model::irradianceRuleFor(1e-4).panels == 12);
  CHECK(model::irradianceRuleFor(1e-9).panels == 12);
}

TEST_CASE("IrradianceField, ColoursOnBothSides") {
  model::Sky sky = fixedSky(*model::findLuminance("cie-12"), 15.0);
  sky.gradient_sun = {1, 3, {1.0F, 0.4F, 0.1F, 0.5F, 0.5F, 0.6F, 0.1F, 0.3F, 0.9F}};
  sky.gradient_anti = {1, 2, {0.2F, 0.3F, 0.8F, 0.4F, 0.2F, 0.6F}};
  model::normalise(sky.gradient_sun, sky.gradient_anti);
  CHECK(worstOf(sky, 8) < model::IrradianceProjector::kError);
}

TEST_CASE("IrradianceField, UniformSkyIsALinearFunction") {
  // E(n) = pi (1 + n_y) / 2. Panels are widest here, and the clip lies inside them.
  const model::Sky sky = fixedSky(*model::findLuminance("cie-5"), 30.0);
  const model::IrradianceProjector projector(sky.luminance);
  const model::IrradianceField field = projector.fieldOf(model::SkyInstant(sky, 0.0));
  for (int row = 0; row < model::IrradianceProjector::kRows; ++row)
    for (const double alpha : {0.0, 0.7, 2.9})
      CHECK(valueOf(field, row, alpha).x ==
            Approx(M_PI * (1.0 + projector.rowY(row)) / 2.0).margin(model::IrradianceProjector::kError * M_PI / 2.0));
  CHECK(field.mean.x == Approx(M_PI / 2.0).epsilon(1e-6));
}

TEST_CASE("IrradianceField, OvercastSky") {
  // L = (1 + 2 sin e) / 3: E of a horizontal surface 7 pi / 9, of a vertical one (pi / 2 + 4 / 3) / 3.
  const model::Sky sky = fixedSky(*model::findLuminance("cie-overcast"), 30.0);
  const model::SkyInstant instant(sky, 0.0);
  const double zenith = instant.luminance({0.0, 1.0, 0.0});
  const model::IrradianceField field = model::IrradianceProjector(sky.luminance).fieldOf(instant);
  const double margin = model::IrradianceProjector::kError * field.mean.x;
  for (const double alpha : {0.0, 0.7, 2.9}) {
    CHECK(valueOf(field, model::IrradianceProjector::kRows - 1, alpha).x ==
          Approx(7.0 * M_PI / 9.0 * zenith).margin(margin));
    CHECK(valueOf(field, 0, alpha).x == Approx((0.5 * M_PI + 4.0 / 3.0) / 3.0 * zenith).margin(margin));
  }
  CHECK(field.excess(1.0, 0.0).x == Approx(7.0 * M_PI / 9.0 * zenith).margin(margin));
}

TEST_CASE("IrradianceField, NearDeltaSkyIsAlmostAClippedCosine") {
  // (1 + c exp(d theta)) / g(0): a lobe over an even sky. Towards the sun the lobe alone gives 2 pi c / (d^2 + 4) /
  // g(0). Elsewhere its share is the cosine of the angle to the sun, except for its width, 2 / 120 rad.
  constexpr double kWidth = 2.0 / 120.0;
  model::Sky sky = fixedSky(*model::findLuminance("cie-5"), 40.0);
  sky.luminance.c = 1e4;
  sky.luminance.d = -120.0;
  const model::SkyInstant instant(sky, 0.0);
  const model::IrradianceProjector projector(sky.luminance);
  const model::IrradianceField field = projector.fieldOf(instant);
  const double at_sun = 1.0 + sky.luminance.c;
  const double most = 2.0 * M_PI * sky.luminance.c / (120.0 * 120.0 + 4.0) / at_sun;
  double worst = 0.0;
  for (int row = 0; row < model::IrradianceProjector::kRows; ++row)
    for (const double alpha : {0.0, 0.7, 1.5, 2.9}) {
      const double y = projector.rowY(row);
      const double even = M_PI * (1.0 + y) / 2.0 / at_sun;
      const double cosine = std::max(dot(instant.sunDirection(), normalAt(y, alpha)), 0.0);
      worst = std::max(worst, std::abs((valueOf(field, row, alpha).x - even) / most - cosine));
    }
  CHECK(worst < kWidth);
}

TEST_CASE("IrradianceField, TruncationIsKnownForLobesThatAreNotResolved") {
  // The series truncates worst at the edge of the lobe's half circle on the horizon.
  for (const double d : {-4.0, -16.0, -60.0, -120.0, -1e3})
    for (const double elevation : {3.0, 45.0}) {
      model::Sky sky = fixedSky(*model::findLuminance("cie-12"), elevation);
      sky.luminance.c = 1e4;
      sky.luminance.d = d;
      const model::SkyInstant instant(sky, 0.0);
      const model::IrradianceProjector projector(sky.luminance);
      const model::IrradianceField field = projector.fieldOf(instant);
      const model::SkyProjector direct(sky.luminance, 1, 1e-5);
      double worst = 0.0;
      for (const int row : {0, 4})
        for (const double alpha : {0.3, 1.4, 0.5 * M_PI, 1.62, 2.0})
          worst = std::max(worst, std::abs(valueOf(field, row, alpha).x -
                                           direct.irradiance(instant, normalAt(projector.rowY(row), alpha)).x) /
                                      field.mean.x);
      const double estimate = projector.truncationOf(field, 0);
      CAPTURE(d, elevation, worst, estimate);
      CHECK(worst < std::max(estimate, model::IrradianceProjector::kError));
      CHECK(worst > estimate / 4.0 - model::IrradianceProjector::kError);
    }
}

}  // namespace welkin::tests
