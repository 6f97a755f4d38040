// SPDX-License-Identifier: Apache-2.0
// The reference by local lights.
#include <catch2/catch.hpp>

#include "closed_forms.h"
#include "probes/directions.h"
#include "probes/reference/light_path.h"
#include "skies.h"

namespace welkin::probes {
namespace {

using tests::bounces;
using tests::checkEstimate;
using tests::darkness;
using tests::kAlbedo;
using tests::kNormals;

}  // namespace

TEST_CASE("Reference, ALightInASphereHasItsClosedForm") {
  constexpr double kRadius_m = 3.0;
  const Surfaces sphere = tests::sphereInside(kRadius_m, 5, kAlbedo);
  const double roughness = tests::roughnessOf(sphere, kRadius_m);
  CHECK(roughness < 4e-4);
  const Tracer tracer(sphere);
  const Number3 intensity(5, 7, 9);
  const Number3 mean = intensity / (kRadius_m * kRadius_m);  // direct irradiance of the wall
  const auto bound = [&](const Number3& expected) { return 3.0 * roughness * expected.z; };
  const LocalLight middle[] = {{{0, 0, 0}, intensity}};
  const LocalLight aside[] = {{{1.1, -0.4, 0.6}, intensity}};
  const Number3 wall = Number3(0.6, 0.0, -0.8) * (kRadius_m * 0.999);
  for (const int n : {1, 2, 5}) {
    const Number3 expected = mean * bounces(kAlbedo, 1, n);
    for (const Number3& normal : kNormals)
      checkEstimate(traceReference(tracer, darkness(), middle, {0.7, 1.2, -0.9}, normal, {4096, n, 1}).local, expected,
                    bound(expected));
    // A point of the wall sees the whole wall alike, wherever the light is.
    checkEstimate(traceReference(tracer, darkness(), aside, wall, unit(-wall), {16384, n, 1}).local, expected,
                  0.003 * expected.z);
  }
  // Elsewhere every bounce after the first is uniform.
  const Number3 within(-0.9, 0.3, 1.2);
  const auto five = traceReference(tracer, darkness(), aside, within, kNormals[2], {65536, 5, 1}).local;
  const auto one = traceReference(tracer, darkness(), aside, within, kNormals[2], {65536, 1, 2}).local;
  Estimate later{five.value - one.value, {}};
  for (int c = 0; c < 3; ++c) later.standard_error[c] = std::hypot(five.standard_error[c], one.standard_error[c]);
  const Number3 expected = mean * bounces(kAlbedo, 2, 5);
  checkEstimate(later, expected, bound(expected));
  CHECK(traceReference(tracer, darkness(), aside, within, kNormals[2], {64, 0, 1}).total.value == Number3(0.0));
}

TEST_CASE("Reference, ALightOverAPlaneSeesItsOwnReflection") {
  // The integral of (rho / pi) I h / d^3 and h^2 / d^4 over the plane: 2 rho I / (5 h^2). Beyond 100 m it is 1e-8; rays
  // leave a larger one by millimetres.
  const Surfaces ground = tests::groundOf(kAlbedo, 100.0);
  const Tracer tracer(ground);
  const LocalLight light[] = {{{0, 2, 0}, {3, 4, 5}}};
  checkEstimate(traceReference(tracer, darkness(), light, {0, 2, 0}, {0, -1, 0}, {16384, 2, 1}).local,
                kAlbedo * Number3(3, 4, 5) * (2.0 / (5.0 * 4.0)));
}

TEST_CASE("Reference, AGlowingSphereShinesLikeAPointUntilOneIsInIt") {
  const Surfaces nothing;
  const Tracer empty(nothing);
  const Number3 normal = unit({0.2, 0.9, -0.3});
  const auto mean = [&](const Tracer& tracer, const LocalLight& light) {
    Random random(3);
    Number3 sum(0.0);
    for (int i = 0; i < 20000; ++i) {
      const double s = random.unit();
      sum += localIrradiance(tracer, light, {1, 2, 3}, normal, s, random.unit());
    }
    return sum.y / 20000.0;
  };
  const Number3 away(0.5, 2.0, -1.0);
  for (const double radius : {0.0, 0.1, 0.9})
    CHECK(mean(empty, {Number3(1, 2, 3) + away, Number3(4.0), radius}) ==
          Approx(4.0 * dot(normal, away) / std::pow(dot(away, away), 1.5)).epsilon(0.005));
  CHECK(mean(empty, {Number3(1, 2, 3) + away, Number3(4.0), 2.5}) == Approx(4.0 / 6.25));
  CHECK(mean(empty, {Number3(1, 2, 3) - away, Number3(4.0), 0.1}) == 0.0);
  Surfaces wall;  // between the light's middle and its far side
  tests::addQuad(wall, Number3(1, 2, 3) + away * 1.2 - Number3(9, 0, 9), {18, 0, 0}, {0, 0, 18},
                 tests::addMaterial(wall, Number3(0.0)));
  const LocalLight before{Number3(1, 2, 3) + away, Number3(4.0), 0.9};
  CHECK(mean(Tracer(wall), before) == mean(empty, before));
  Surfaces half;  // up to the middle of the light
  tests::addQuad(half, {1.2, 0, 0}, {0, 9, 0}, {0, 0, 9}, tests::addMaterial(half, Number3(0.0)));
  const LocalLight behind{{1, 4, 3}, Number3(4.0), 0.8};
  const double whole = mean(empty, behind);
  const double part = mean(Tracer(half), behind);
  CHECK(part > 0.6 * whole);
  CHECK(part < 0.9 * whole);
}

}  // namespace welkin::probes
