// SPDX-License-Identifier: Apache-2.0
// The reference under local lights.
#include <catch2/catch.hpp>

#include "probes/geometry/directions.h"
#include "probes/reference/light_path.h"
#include "skies.h"
#include "tests/probes/closed_forms/closed_forms.h"

namespace welkin::tests {

using f64::Number3;
namespace {}  // namespace

TEST_CASE("Reference, ALightInASphereHasItsClosedForm") {
  constexpr double kRadius_m = 3.0;
  const geometry::Surfaces sphere = sphereInside(kRadius_m, 5, kAlbedo);
  const double roughness = roughnessOf(sphere, kRadius_m);
  CHECK(roughness < 4e-4);
  const geometry::Tracer tracer(sphere);
  const Number3 intensity(5, 7, 9);
  const Number3 mean = intensity / (kRadius_m * kRadius_m);  // direct irradiance of the wall
  const auto bound = [&](const Number3& expected) { return 3.0 * roughness * expected.z; };
  const reference::LocalLight middle[] = {{{0, 0, 0}, intensity}};
  const reference::LocalLight aside[] = {{{1.1, -0.4, 0.6}, intensity}};
  const Number3 wall = Number3(0.6, 0.0, -0.8) * (kRadius_m * 0.999);
  for (const int n : {1, 2, 5}) {
    const Number3 expected = mean * bounces(kAlbedo, 1, n);
    for (const Number3& normal : kNormals)
      checkEstimate(reference::traceReference(tracer, darkness(), middle, {0.7, 1.2, -0.9}, normal, {4096, n, 1}).local,
                    expected, bound(expected));
    // Every point of the wall sees the whole wall alike, wherever the light is.
    checkEstimate(
        reference::traceReference(tracer, darkness(), aside, wall, geometry::unit(-wall), {16384, n, 1}).local,
        expected, 0.003 * expected.z);
  }
  // Elsewhere every bounce after the first is uniform.
  const Number3 within(-0.9, 0.3, 1.2);
  const auto five = reference::traceReference(tracer, darkness(), aside, within, kNormals[2], {65536, 5, 1}).local;
  const auto one = reference::traceReference(tracer, darkness(), aside, within, kNormals[2], {65536, 1, 2}).local;
  reference::Estimate later{five.value - one.value, {}};
  for (int c = 0; c < 3; ++c) later.standard_error[c] = std::hypot(five.standard_error[c], one.standard_error[c]);
  const Number3 expected = mean * bounces(kAlbedo, 2, 5);
  checkEstimate(later, expected, bound(expected));
  CHECK(reference::traceReference(tracer, darkness(), aside, within, kNormals[2], {64, 0, 1}).total.value ==
        Number3(0.0));
}

TEST_CASE("Reference, ALightOverAPlaneSeesItsOwnReflection") {
  // The integral of (rho / pi) I h / d^3 and h^2 / d^4 over the plane is 2 rho I / (5 h^2). The part beyond 100 m is
  // 1e-8; on a larger plane, rays would start millimetres off.
  const geometry::Surfaces ground = groundOf(kAlbedo, 100.0);
  const geometry::Tracer tracer(ground);
  const reference::LocalLight light[] = {{{0, 2, 0}, {3, 4, 5}}};
  checkEstimate(reference::traceReference(tracer, darkness(), light, {0, 2, 0}, {0, -1, 0}, {16384, 2, 1}).local,
                kAlbedo * Number3(3, 4, 5) * (2.0 / (5.0 * 4.0)));
}

TEST_CASE("Reference, AGlowingSphereShinesLikeAPointUntilOneIsInIt") {
  const geometry::Surfaces nothing;
  const geometry::Tracer empty(nothing);
  const Number3 normal = geometry::unit({0.2, 0.9, -0.3});
  const auto mean = [&](const geometry::Tracer& tracer, const reference::LocalLight& light) {
    geometry::Random random(3);
    Number3 sum(0.0);
    for (int i = 0; i < 20000; ++i) {
      const double s = random.unit();
      sum += reference::localIrradiance(tracer, light, {1, 2, 3}, normal, s, random.unit());
    }
    return sum.y / 20000.0;
  };
  const Number3 away(0.5, 2.0, -1.0);
  for (const double radius : {0.0, 0.1, 0.9})
    CHECK(mean(empty, {Number3(1, 2, 3) + away, Number3(4.0), radius}) ==
          Approx(4.0 * dot(normal, away) / std::pow(dot(away, away), 1.5)).epsilon(0.005));
  CHECK(mean(empty, {Number3(1, 2, 3) + away, Number3(4.0), 2.5}) == Approx(4.0 / 6.25));
  CHECK(mean(empty, {Number3(1, 2, 3) - away, Number3(4.0), 0.1}) == 0.0);
  geometry::Surfaces wall;  // between the light's middle and its far side
  addQuad(wall, Number3(1, 2, 3) + away * 1.2 - Number3(9, 0, 9), {18, 0, 0}, {0, 0, 18},
          addMaterial(wall, Number3(0.0)));
  const reference::LocalLight before{Number3(1, 2, 3) + away, Number3(4.0), 0.9};
  CHECK(mean(geometry::Tracer(wall), before) == mean(empty, before));
  geometry::Surfaces half;  // up to the middle of the light
  addQuad(half, {1.2, 0, 0}, {0, 9, 0}, {0, 0, 9}, addMaterial(half, Number3(0.0)));
  const reference::LocalLight behind{{1, 4, 3}, Number3(4.0), 0.8};
  const double whole = mean(empty, behind);
  const double part = mean(geometry::Tracer(half), behind);
  CHECK(part > 0.6 * whole);
  CHECK(part < 0.9 * whole);
}

}  // namespace welkin::tests
