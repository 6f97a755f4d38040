// SPDX-License-Identifier: Apache-2.0
// The model, the bake and the runtime at the ends of their domain. always.h lists the properties.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "extreme_skies.h"

namespace welkin::tests {
namespace {

constexpr double kLeast = std::numeric_limits<double>::denorm_min();

/// Largest error of a coefficient, relative to c0, between a bake's rule and the rule that keeps 1e-12.
double errorOfABake(const model::Sky& model, int bands) {
  const model::SkyInstant instant(model, 0.0);
  const table::DayTable table = table::bakeDayTable(model, bands, {0.0}, {});
  const model::PolarMoments finest = model::SkyProjector(model.luminance, bands, 1e-12).projectPolar(instant);
  double largest = 0.0;
  for (std::size_t i = 0; i < finest.radiance_sh.size(); ++i)
    largest = std::max(largest,
                       std::abs(table.number[i * static_cast<std::size_t>(table.channels)] - finest.radiance_sh[i].x));
  return largest / finest.radiance_sh[0].x;
}

const double kElevations[] = {0.0,
                              kLeast,
                              -kLeast,
                              1e-12,
                              -1e-12,
                              1e-4,
                              -1e-4,
                              -18.0 * kDegree,
                              45.0 * kDegree,
                              det::kHalfPi,
                              std::nextafter(det::kHalfPi, 0.0),
                              -det::kHalfPi,
                              std::nextafter(-det::kHalfPi, 0.0)};

TEST_CASE("Extremes, SunAtTheHorizonTheZenithAndTheNadir") {
  int looks = 0;
  for (const auto& [name, luminance] : model::namedLuminances())
    for (const bool to_sun : {true, false})
      for (const double elevation : kElevations)
        for (const double azimuth : {0.0, 2.5}) {
          model::Sky model = coloured(luminance, to_sun);
          model.sun.path = still(azimuth, elevation);
          CAPTURE(name, to_sun, elevation, azimuth);
          const Baked baked(model, 2 + looks % 4, std::vector<double>{0.0});
          looks += holds(model, baked, 7.0);
        }
  REQUIRE(looks == 17 * 2 * 13 * 2);
}

/// All combinations of ends and middles that the loader accepts under a sun.
std::vector<model::LuminanceModel> modelsAtTheEnds(const model::LightPath& sun) {
  std::vector<model::LuminanceModel> models;
  for (const double a : {-1e4, -1.0, 0.0, 1e4})
    for (const double b : {-1e4, -1.0, -1e-8, -kLeast})
      for (const double c : {-1e4, -1e-3, 24.0, 1e4})
        for (const double d : {-1e4, -50.0, -1.0, -kLeast})
          for (const double e : {-1e4, -0.9, 0.0, 1e4})
            if (const model::LuminanceModel m{a, b, c, d, e, 0.0}; !model::whyUnusable(m, sun)) models.push_back(m);
  return models;
}

TEST_CASE("Extremes, CoefficientsAtTheEndsOfTheirDomain") {
  const model::LightPath sun = still(0.3, 0.4);
  const auto models = modelsAtTheEnds(sun);
  REQUIRE(models.size() > 100);
  bool to_sun = false;
  for (const model::LuminanceModel& m : models) {
    to_sun = !to_sun;
    CAPTURE(m.a, m.b, m.c, m.d, m.e, to_sun);
    model::Sky model = coloured(m, to_sun);
    model.sun.path = sun;
    const Baked baked(model, 3, std::vector<double>{0.0});
    holds(model, baked, 12.0);
  }
}

TEST_CASE("Extremes, TheFinestRuleHasTheClosedForms") {
  constexpr double kFinest = 1e-11;
  const auto c0 = [](const model::LuminanceModel& m, double elevation) {
    model::Sky model;
    model.luminance = m;
    model.sun.path = still(0.3, elevation);
    const model::SkyInstant instant(model, 0.0);
    return model::SkyProjector(m, 2, 1e-12).project(instant).radiance_sh[0].x * instant.luminanceNorm() /
           det::kShConstant;
  };
  // Near-delta lobes about the zenith: the integral of exp(d theta) sin theta is (d exp(d pi/2) + 1) / (1 + d^2).
  for (const double c : {1.0, 24.0, 1e4})
    for (const double d : {-1e-9, -3.0, -50.0, -1e3, -1e4}) {
      CAPTURE(c, d);
      const double right = std::exp(d * M_PI / 2.0);
      const double lobe = (d * right + 1.0) / (1.0 + d * d);
      CHECK(c0({0.0, -1.0, c, d, 0.0, 0.0}, M_PI / 2) ==
            Approx(2.0 * M_PI * (1.0 - c * right + c * lobe)).epsilon(kFinest));
    }
  // Layers at the horizon: the integral of exp(b / y) over [0, 1] is the exponential integral E2(-b).
  for (const double a : {-1.0, -0.9, 1e4})
    for (const double b : {-1.0, -0.08, -1e-3, -1e-6, -1e-8}) {
      CAPTURE(a, b);
      const double e2 = std::exp(b) - b * std::expint(b);
      const double slack = std::abs(1.0 + a * e2) < 1e-6 ? 1e-8 : kFinest;  // cancels in the closed form itself
      CHECK(c0({a, b, 0.0, -1.0, 0.0, 0.0}, 0.5) == Approx(2.0 * M_PI * (1.0 + a * e2)).epsilon(slack));
    }
}

TEST_CASE("Extremes, ABakeKeepsItsToleranceAtTheEndsOfTheCoefficients") {
  double largest = 0.0;
  model::LuminanceModel worst{};
  for (const double elevation : {0.0, 1.2}) {
    model::Sky model;
    model.sun.path = still(0.3, elevation);
    const auto models = modelsAtTheEnds(model.sun.path);
    for (std::size_t i = elevation > 0.0 ? 1 : 0; i < models.size(); i += 2) {
      const model::LuminanceModel& m = models[i];
      model.luminance = m;
      const double error = errorOfABake(model, 2);
      if (error <= largest) continue;
      largest = error;
      worst = m;
    }
  }
  CAPTURE(worst.a, worst.b, worst.c, worst.d, worst.e);
  CHECK(largest < model::kTolerance);
  CHECK(largest > 1e-8);  // a difference was measured
}

}  // namespace
}  // namespace welkin::tests
