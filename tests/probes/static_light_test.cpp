// SPDX-License-Identifier: Apache-2.0
// The level's own lights: their falloff, and the light that they bounce to a point, by the reference and by transfer.
#include "probes/geometry/static_light.h"

#include <catch2/catch.hpp>
#include <functional>

#include "skies.h"
#include "tests/probes/closed_forms/closed_forms.h"
#include "tests/probes/transfer/transfer_helpers.h"

namespace welkin::tests {

using f64::Number3;
namespace {

constexpr double kHeight_m = 2.0;
const Number3 kIntensity(3, 4, 5);

geometry::StaticLight pointLight(const Number3& position = {0, kHeight_m, 0}) {
  geometry::StaticLight light;
  light.position = position;
  light.intensity = kIntensity;
  return light;
}

geometry::StaticLight sunLight(const Number3& towards) {
  geometry::StaticLight light;
  light.directional = true;
  light.intensity = kIntensity;
  light.axis = -towards;
  return light;
}

/// Irradiance of the light's own place from below, for a light over a plane of kAlbedo that has the share `of` of its
/// intensity at the cosine c off the vertical: 2 rho I / h^2 times the integral of share c^4 dc, by the midpoint rule.
Number3 seenFromTheLight(const std::function<double(double)>& of) {
  constexpr int kSteps = 100000;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double c = (i + 0.5) / kSteps;
    sum += of(c) * c * c * c * c / kSteps;
  }
  return kAlbedo * kIntensity * (2.0 * sum / (kHeight_m * kHeight_m));
}

/// The light that a level bounces to a point with the normal down, by the reference and by transfer.
void checkFromBelow(const geometry::Surfaces& level, const Number3& position, const Number3& expected, int bounces = 1,
                    const Number3& ground_albedo = Number3(0.0)) {
  const geometry::Tracer tracer(level);
  static model::Sky sky;
  sky = uniformSky(0.0);
  sky.ground_albedo = ground_albedo;
  checkEstimate(reference::traceReference(tracer, reference::DistantLight(sky, 12.0), {}, position, {0, -1, 0},
                                          {16384, bounces, 1})
                    .local,
                expected);
  transfer::TransferSettings settings = settingsOf(bounces, 1024);
  settings.ground_albedo = ground_albedo;
  const transfer::TransferTracer transfer(tracer, settings);
  constexpr std::size_t kDown = 3;
  for (int c = 0; c < 3; ++c)
    checkMeasured(measured(transfer, position, kProbes,
                           [&](const transfer::TracedProbe& p) { return p.transfer.emitted[kDown][c]; }),
                  expected[c]);
}

}  // namespace

TEST_CASE("StaticLight, HasTheFalloffOfItsKind") {
  const Number3 up(0, 1, 0);
  geometry::StaticLight light = pointLight();
  const Number3 aside = geometry::arrivingAt(light, {2, 0, 0}, up).irradiance;  // cos 45 deg / 8
  for (int c = 0; c < 3; ++c) CHECK(aside[c] == Approx(kIntensity[c] * std::sqrt(0.5) / 8.0));
  CHECK(geometry::arrivingAt(light, {2, 0, 0}, up).distance == Approx(std::sqrt(8.0)));
  CHECK(geometry::arrivingAt(light, {2, 0, 0}, -up).irradiance == Number3(0.0));
  CHECK(geometry::arrivingAt(light, light.position, up).irradiance == Number3(0.0));
  const auto below = [&] { return geometry::arrivingAt(light, {0, 0, 0}, up).irradiance.x * 4.0 / kIntensity.x; };
  light.inverse_range4 = 1.0 / 256.0;  // a range of 4 m: 1 - (2 / 4)^4 is left
  CHECK(below() == Approx(0.9375));
  light.inverse_range4 = 1.0 / 16.0;
  CHECK(below() == 0.0);
  light = pointLight();
  geometry::setCone(light, 0.2, 0.5);
  CHECK(below() == Approx(1.0));
  light.axis = geometry::unit({std::tan(0.3), -1, 0});  // the point lies 0.3 off the axis
  const double inside = (std::cos(0.3) - std::cos(0.5)) / (std::cos(0.2) - std::cos(0.5));
  CHECK(below() == Approx(inside * inside));
  light.axis = geometry::unit({std::tan(0.51), -1, 0});
  CHECK(below() == 0.0);
  light.axis = {0, 1, 0};
  CHECK(below() == 0.0);
  const geometry::StaticLight sun = sunLight(geometry::unit({1, 1, 0}));
  CHECK(geometry::arrivingAt(sun, {700, 3, 9}, up).irradiance.y == Approx(kIntensity.y * std::sqrt(0.5)));
  CHECK(geometry::arrivingAt(sun, {700, 3, 9}, -up).irradiance == Number3(0.0));
}

TEST_CASE("StaticLight, BouncesOffAPlaneByItsClosedForm") {
  // The part of the plane beyond 100 m is 1e-8; on a larger plane, rays would start millimetres off.
  geometry::Surfaces level = groundOf(kAlbedo, 100.0);
  level.light = {pointLight()};
  const Number3 position = level.light[0].position;
  checkFromBelow(level, position, kAlbedo * kIntensity * (2.0 / (5.0 * kHeight_m * kHeight_m)));
  geometry::setCone(level.light[0], 0.3, 0.9);
  level.light[0].inverse_range4 = 1.0 / 81.0;
  checkFromBelow(level, position, seenFromTheLight([](double c) {
                   const double cone = (c - std::cos(0.9)) / (std::cos(0.3) - std::cos(0.9));
                   const double d = kHeight_m / c;
                   return std::pow(std::clamp(cone, 0.0, 1.0), 2) * std::max(1.0 - d * d * d * d / 81.0, 0.0);
                 }));
  level.light[0].axis = {0, 1, 0};
  checkFromBelow(level, position, Number3(0.0));
}

TEST_CASE("StaticLight, ParallelLightAlsoShinesOnTheGroundBeyond") {
  const Number3 towards = geometry::unit({0.3, 0.8, -0.2});
  geometry::Surfaces level = groundOf(kAlbedo, 3.0);  // its edge is in sight
  level.light = {sunLight(towards)};
  checkFromBelow(level, {0, 2, 0}, kAlbedo * kIntensity * towards.y, 1, kAlbedo);
  addQuad(level, {-1, 1, -1}, {0, 0, 2}, {2, 0, 0}, addMaterial(level, Number3(0.0), true));
  const geometry::Tracer tracer(level);  // just under the panel, in its shadow
  const auto shaded =
      reference::traceReference(tracer, darkness(), {}, {0, 0.5, 0}, {0, -1, 0}, {4096, 1, 1}).local.value;
  CHECK(shaded.y < 0.5 * kAlbedo.y * kIntensity.y * towards.y);
}

TEST_CASE("StaticLight, ManyLightsAddUpAndWallsStopThem") {
  constexpr int kLights = 40;  // more than a vertex tests
  geometry::Surfaces level = groundOf(kAlbedo, 100.0);
  for (int i = 0; i < kLights; ++i) {
    level.light.push_back(pointLight());
    level.light.back().intensity = kIntensity * ((i % 5) / 80.0);
  }
  checkFromBelow(level, level.light[0].position, kAlbedo * kIntensity * (2.0 / (5.0 * kHeight_m * kHeight_m)));
  geometry::Surfaces rooms = twoRooms(Number3(0.5), false);
  rooms.light = {pointLight({-2, 1.5, 0.3})};
  const geometry::Tracer tracer(rooms);
  const auto lit = [&](double x) {
    const double e =
        reference::traceReference(tracer, darkness(), {}, {x, 1.5, 0}, {0, 1, 0}, {1024, 3, 1}).local.value.x;
    CHECK((transfer::traceTransfer(tracer, {x, 1.5, 0}, settingsOf(3), {0, 0}, 0).emitted[0].x > 0.0) == (e > 0.0));
    return e;
  };
  CHECK(lit(-2.0) > 0.1);
  CHECK(lit(2.0) == 0.0);
}

TEST_CASE("StaticLight, AProbeSeesLightsWithinItsReachAlone") {
  geometry::Surfaces level = groundOf(kAlbedo, 100.0);
  level.light = {pointLight({30, 2, 0})};
  const geometry::Tracer tracer(level);
  const auto emitted = [&](double reach_m) {
    transfer::TransferSettings settings = settingsOf(1, 4096);
    settings.reach_m = reach_m;
    return transfer::traceTransfer(tracer, {0, 2, 0}, settings, {0, 0}, 0).emitted[3].y;
  };
  CHECK(emitted(31.0) > 0.0);
  CHECK(emitted(29.0) == 0.0);
}

}  // namespace welkin::tests
