// SPDX-License-Identifier: Apache-2.0
// The transfer beside the plain path tracer where no closed form is known.
#include <catch2/catch.hpp>

#include "closed_forms.h"
#include "probes/transfer/relight.h"
#include "skies.h"
#include "transfer_helpers.h"

namespace welkin::probes {
namespace {

/// A yard open to the south and to one side, in colours, with a lamp of an emissive panel and a roof over a corner; it
/// ends after 30 m, where the ground beyond begins.
Surfaces yard() {
  Surfaces s = tests::groundOf({0.5, 0.4, 0.3}, 30);
  const auto red = tests::addMaterial(s, {0.8, 0.2, 0.1}, true);
  const auto blue = tests::addMaterial(s, {0.1, 0.3, 0.9});
  const auto lamp = tests::addMaterial(s, Number3(0.5), false, {2.0, 1.0, 0.5});
  tests::addQuad(s, {-6, 0, -5}, {12, 0, 0}, {0, 7, 0}, red);
  tests::addQuad(s, {6, 0, -5}, {0, 0, 9}, {0, 4, 0}, blue);
  tests::addQuad(s, {-6, 4, -5}, {5, 0, 0}, {0, 0.5, 5}, red);
  tests::addQuad(s, {-5, 0.5, -4.9}, {4, 0, 0}, {0, 3, 0}, lamp);
  return s;
}

/// Coefficients of the sky's radiance, 2 bands, by the midpoint rule.
std::array<Number3, 4> coefficientsOf(const DistantLight& light) {
  std::array<Number3, 4> sh{};
  constexpr int kRows = 200;
  constexpr int kColumns = 400;
  for (int i = 0; i < kRows; ++i)
    for (int j = 0; j < kColumns; ++j) {
      const Number3 w = tests::towards(det::kTwoPi * (j + 0.5) / kColumns, std::asin((i + 0.5) / kRows));
      const auto y = f64::shBasis(w);
      for (std::size_t k = 0; k < 4; ++k)
        sh[k] += light.skyRadiance(w) * (y.v[k] * det::kTwoPi / (double{kRows} * kColumns));
    }
  return sh;
}

/// Root of the mean square error of the sky's bounced light at two probes, by direction and channel, over its root mean
/// square.
double bounceError(const Surfaces& surfaces, const sky::Sky& sky, SkyBounce way) {
  const Tracer tracer(surfaces);
  const DistantLight light(sky, 12.0);
  TransferSettings settings;
  settings.rays = 1U << 14;
  settings.ground_albedo = sky.ground_albedo;
  const Relight relight = relightAt(12.0, coefficientsOf(light), {}, {}, SunTransfer::none, {}, {}, way);
  double squares = 0.0;
  double all = 0.0;
  for (const Number3& at : {Number3(-3, 1, -2.5), Number3(2, 2.5, 1)}) {
    ProbeTransfer t = traceTransfer(tracer, at, settings, {0, 0}, 0);
    t.visibility = {};  // the bounce alone
    const ProbeIrradiance e = relit(t, {}, relight);
    for (std::size_t b = 0; b < kDirections; ++b) {
      const auto all_of = traceReference(tracer, light, {}, at, transferBasis()[b], {1U << 15, 2, 0});
      const auto direct = traceReference(tracer, light, {}, at, transferBasis()[b], {1U << 15, 0, 0});
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
  const Surfaces surfaces = yard();
  const Tracer tracer(surfaces);
  constexpr double kAzimuth = 2.2;
  constexpr double kElevation = 0.6;
  constexpr std::size_t kProbes = 32;
  for (const int bounces : {1, 3}) {
    sky::Sky sky = tests::uniformSky(1.0, kAzimuth, kElevation);
    sky.sun.illuminance = sky::Curve::constant(1.0);
    sky.ground_albedo = {0.3, 0.6, 0.2};
    TransferSettings settings;
    settings.rays = 512;
    settings.bounces = bounces;
    settings.ground_albedo = sky.ground_albedo;
    settings.light_directions = {tests::towards(0.1, 0.9), tests::towards(kAzimuth, kElevation)};
    settings.light_rays = 1;
    const TransferTracer transfer(tracer, settings);
    ReferenceSettings reference_settings;
    reference_settings.samples = 1U << 16;
    reference_settings.bounces = bounces;
    const DistantLight light(sky, 12.0);
    for (const Number3& at : {Number3(-3, 1, -2.5), Number3(2, 2.5, 1)})
      for (std::size_t b = 0; b < kDirections; ++b) {
        CAPTURE(bounces, at.x, b);
        const auto truth = traceReference(tracer, light, {}, at, transferBasis()[b], reference_settings);
        for (int c = 0; c < 3; ++c) {
          const auto agrees = [&](const Estimate& expected, auto&& quantity) {
            const auto m =
                tests::measured(transfer, at, kProbes, [&](const TracedProbe& p) { return quantity(p.transfer); });
            tests::checkMeasured({m.mean, std::hypot(m.standard_error, expected.standard_error[c])}, expected.value[c],
                                 1e-12);
            CHECK(m.mean > 0.0);
          };
          agrees(truth.sky, [&](const ProbeTransfer& t) {
            return t.visibility[b] * det::kPi * (1.0 + transferBasis()[b].y) / 2.0 + t.sky[b][0][c] / det::kShConstant;
          });
          agrees(truth.sun_bounce, [&](const ProbeTransfer& t) { return t.sun[b][1][c]; });
          agrees(truth.local, [&](const ProbeTransfer& t) { return t.emitted[b][c]; });
        }
      }
  }
}

TEST_CASE("TransferReference, TheSkysBounceIsNearerByTheFit") {
  // The rest of the fit's error under a uniform sky is noise.
  const Surfaces surfaces = yard();
  sky::Sky uniform = tests::uniformSky(1.0);
  uniform.ground_albedo = {0.3, 0.6, 0.2};
  const double uniform_projected = bounceError(surfaces, uniform, SkyBounce::projected);
  const double uniform_fitted = bounceError(surfaces, uniform, SkyBounce::fitted);
  CAPTURE(uniform_projected, uniform_fitted);
  CHECK(uniform_projected > 0.05);
  CHECK(uniform_fitted < 0.03);
  for (const double elevation : {0.15, 0.6, 1.2}) {
    sky::Sky clear = tests::clearSky(2.2, elevation);
    clear.ground_albedo = uniform.ground_albedo;
    const double projected = bounceError(surfaces, clear, SkyBounce::projected);
    const double fitted = bounceError(surfaces, clear, SkyBounce::fitted);
    CAPTURE(elevation, projected, fitted);
    CHECK(fitted < projected);
  }
}

}  // namespace welkin::probes
