// SPDX-License-Identifier: Apache-2.0
// The transfer compared with the plain path tracer where no closed form is known.
#include <catch2/catch.hpp>

#include "probes/transfer/relight.h"
#include "tests/probes/closed_forms/closed_forms.h"
#include "tests/probes/skies.h"
#include "transfer_helpers.h"

namespace welkin::tests {

using f64::Number3;
namespace {

/// A coloured yard open to the south and to one side, with an emissive panel as a lamp and a roof over a corner. It
/// ends after 30 m, where the ground beyond begins.
geometry::Surfaces yard() {
  geometry::Surfaces s = groundOf({0.5, 0.4, 0.3}, 30);
  const auto red = addMaterial(s, {0.8, 0.2, 0.1}, true);
  const auto blue = addMaterial(s, {0.1, 0.3, 0.9});
  const auto lamp = addMaterial(s, Number3(0.5), false, {2.0, 1.0, 0.5});
  addQuad(s, {-6, 0, -5}, {12, 0, 0}, {0, 7, 0}, red);
  addQuad(s, {6, 0, -5}, {0, 0, 9}, {0, 4, 0}, blue);
  addQuad(s, {-6, 4, -5}, {5, 0, 0}, {0, 0.5, 5}, red);
  addQuad(s, {-5, 0.5, -4.9}, {4, 0, 0}, {0, 3, 0}, lamp);
  return s;
}

/// Coefficients of the sky's radiance, 2 bands, by the midpoint rule.
std::array<Number3, 4> coefficientsOf(const reference::DistantLight& light) {
  std::array<Number3, 4> sh{};
  constexpr int kRows = 200;
  constexpr int kColumns = 400;
  for (int i = 0; i < kRows; ++i)
    for (int j = 0; j < kColumns; ++j) {
      const Number3 w = towards(det::kTwoPi * (j + 0.5) / kColumns, std::asin((i + 0.5) / kRows));
      const auto y = f64::shBasis(w);
      for (std::size_t k = 0; k < 4; ++k)
        sh[k] += light.skyRadiance(w) * (y.v[k] * det::kTwoPi / (double{kRows} * kColumns));
    }
  return sh;
}

/// Root mean square error of the sky's bounced light at two probes, by direction and channel, over its root mean
/// square.
double bounceError(const geometry::Surfaces& surfaces, const model::Sky& sky, transfer::SkyBounce way) {
  const geometry::Tracer tracer(surfaces);
  const reference::DistantLight light(sky, 12.0);
  transfer::TransferSettings settings;
  settings.rays = 1U << 14;
  settings.ground_albedo = sky.ground_albedo;
  const transfer::Relight relight =
      transfer::relightAt(12.0, coefficientsOf(light), {}, {}, transfer::SunTransfer::none, {}, {}, way);
  double squares = 0.0;
  double all = 0.0;
  for (const Number3& at : {Number3(-3, 1, -2.5), Number3(2, 2.5, 1)}) {
    transfer::ProbeTransfer t = transfer::traceTransfer(tracer, at, settings, {0, 0}, 0);
    t.visibility = {};  // the bounce alone
    const transfer::ProbeIrradiance e = transfer::relit(t, {}, relight);
    for (std::size_t b = 0; b < transfer::kDirections; ++b) {
      const auto all_of =
          reference::traceReference(tracer, light, {}, at, transfer::transferBasis()[b], {1U << 15, 2, 0});
      const auto direct =
          reference::traceReference(tracer, light, {}, at, transfer::transferBasis()[b], {1U << 15, 0, 0});
      for (int c = 0; c < 3; ++c) {
        const double truth = all_of.sky.value[c] - direct.sky.value[c];
        squares += (e.sky[b][c] - truth) * (e.sky[b][c] - truth);
        all += truth * truth;
      }
    }
  }
  return std::sqrt(squares / all);
}

}  // namespace

TEST_CASE("TransferReference, AgreesInAYard") {
  const geometry::Surfaces surfaces = yard();
  const geometry::Tracer tracer(surfaces);
  constexpr double kAzimuth = 2.2;
  constexpr double kElevation = 0.6;
  constexpr std::size_t kIndependent = 32;
  for (const int bounces : {1, 3}) {
    model::Sky sky = uniformSky(1.0, kAzimuth, kElevation);
    sky.sun.illuminance = base::Curve::constant(1.0);
    sky.ground_albedo = {0.3, 0.6, 0.2};
    transfer::TransferSettings settings;
    settings.rays = 512;
    settings.bounces = bounces;
    settings.ground_albedo = sky.ground_albedo;
    settings.light_directions = {towards(0.1, 0.9), towards(kAzimuth, kElevation)};
    settings.light_rays = 1;
    const transfer::TransferTracer transfer(tracer, settings);
    reference::ReferenceSettings reference_settings;
    reference_settings.samples = 1U << 16;
    reference_settings.bounces = bounces;
    const reference::DistantLight light(sky, 12.0);
    for (const Number3& at : {Number3(-3, 1, -2.5), Number3(2, 2.5, 1)})
      for (std::size_t b = 0; b < transfer::kDirections; ++b) {
        CAPTURE(bounces, at.x, b);
        const auto truth =
            reference::traceReference(tracer, light, {}, at, transfer::transferBasis()[b], reference_settings);
        for (int c = 0; c < 3; ++c) {
          const auto agrees = [&](const reference::Estimate& expected, auto&& quantity) {
            const auto m = measured(transfer, at, kIndependent,
                                    [&](const transfer::TracedProbe& p) { return quantity(p.transfer); });
            checkMeasured({m.mean, std::hypot(m.standard_error, expected.standard_error[c])}, expected.value[c], 1e-12);
            CHECK(m.mean > 0.0);
          };
          agrees(truth.sky, [&](const transfer::ProbeTransfer& t) {
            return t.visibility[b] * det::kPi * (1.0 + transfer::transferBasis()[b].y) / 2.0 +
                   t.sky[b][0][c] / det::kShConstant;
          });
          agrees(truth.sun_bounce, [&](const transfer::ProbeTransfer& t) { return t.sun[b][1][c]; });
          agrees(truth.local, [&](const transfer::ProbeTransfer& t) { return t.emitted[b][c]; });
        }
      }
  }
}

TEST_CASE("TransferReference, TheSkysBounceIsNearerByTheFit") {
  // The rest of the fit's error under a uniform sky is noise.
  const geometry::Surfaces surfaces = yard();
  model::Sky uniform = uniformSky(1.0);
  uniform.ground_albedo = {0.3, 0.6, 0.2};
  const double uniform_projected = bounceError(surfaces, uniform, transfer::SkyBounce::projected);
  const double uniform_fitted = bounceError(surfaces, uniform, transfer::SkyBounce::fitted);
  CAPTURE(uniform_projected, uniform_fitted);
  CHECK(uniform_projected > 0.05);
  CHECK(uniform_fitted < 0.03);
  for (const double elevation : {0.15, 0.6, 1.2}) {
    model::Sky clear = clearSky(2.2, elevation);
    clear.ground_albedo = uniform.ground_albedo;
    const double projected = bounceError(surfaces, clear, transfer::SkyBounce::projected);
    const double fitted = bounceError(surfaces, clear, transfer::SkyBounce::fitted);
    CAPTURE(elevation, projected, fitted);
    CHECK(fitted < projected);
  }
}

}  // namespace welkin::tests
