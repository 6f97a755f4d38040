// SPDX-License-Identifier: Apache-2.0
// The reference inside closed levels, by local lights, and as an estimator.
#include <catch2/catch.hpp>

#include "closed_forms.h"
#include "probes/directions.h"
#include "probes/reference/light_path.h"
#include "skies.h"

namespace welkin::probes {
namespace {

using tests::checkEstimate;

const Number3 kAlbedo(0.2, 0.5, 0.9);
const std::vector<Number3> kNormals = {{0, 1, 0}, {0, -1, 0}, unit({0.3, 0.5, -0.7}), unit({-0.8, -0.1, 0.4})};

DistantLight darkness() {
  static const sky::Sky sky = tests::uniformSky(0.0);
  return {sky, 12.0};
}

/// sum of albedo^i, i from `first` to `last`.
Number3 bounces(const Number3& albedo, int first, int last) {
  Number3 sum(0.0);
  Number3 power(1.0);
  for (int i = 0; i <= last; ++i) {
    if (i >= first) sum += power;
    power = power * albedo;
  }
  return sum;
}

/// A place without symmetry: a courtyard with a block in it and half a roof.
Surfaces yard() {
  Surfaces s = tests::wellOf(4.0, 5.0, 4, {0.6, 0.5, 0.3}, {0.4, 0.6, 0.8});
  const auto block = tests::addMaterial(s, {0.9, 0.3, 0.2});
  tests::addBoxOutside(s, {0.5, 0, -2.5}, {2.2, 2.1, -0.7}, block);
  tests::addQuad(s, {-4, 4, -4}, {8, 0, 0}, {0, 0, 3}, tests::addMaterial(s, {0.7, 0.7, 0.7}, true));
  return s;
}

}  // namespace

TEST_CASE("Reference, AClosedBoxThatShinesIsAFurnaceOfItsBounces") {
  Surfaces box;
  const Number3 emission(1.5, 0.5, 2.0);
  tests::addBoxInside(box, {-1, 0, -3}, {2, 2.5, 1}, tests::addMaterial(box, kAlbedo, false, emission));
  const Tracer tracer(box);
  for (const int n : {0, 1, 2, 9})
    for (const Number3& normal : kNormals) {
      const auto e = traceReference(tracer, darkness(), {}, {0.3, 1, -0.4}, normal, {256, n, 1});
      const Number3 ratio = bounces(kAlbedo, 0, n);
      CHECK(ratio.y == Approx((1.0 - std::pow(kAlbedo.y, n + 1)) / (1.0 - kAlbedo.y)));
      checkEstimate(e.local, emission * ratio * det::kPi);
      CHECK(e.local.standard_error.y <= 1e-12);
    }
}

TEST_CASE("Reference, WhiteSurfacesUnderAUniformSkyAreAFurnaceOfAnyShape") {
  Surfaces level = tests::groundOf(Number3(1.0), tests::kEndless_m);
  tests::addBoxOutside(level, {0.5, 0, -2.5}, {2.2, 2.1, -0.7}, tests::addMaterial(level, Number3(1.0)));
  const Tracer tracer(level);
  sky::Sky sky = tests::uniformSky(1.0);
  sky.ground_albedo = Number3(1.0);
  constexpr int kAll = 100;  // more than half of the light leaves at every bounce
  for (const Number3& normal : kNormals)
    for (const Number3& p : {Number3(0.2, 0.3, -1), Number3(1, 2.1001, -1), Number3(0.49, 0.01, -0.69)})
      checkEstimate(traceReference(tracer, DistantLight(sky, 0.0), {}, p, normal, {1024, kAll, 1}).sky,
                    Number3(det::kPi));
}

TEST_CASE("Reference, AShiningSquareHasLambertsIrradiance") {
  Surfaces s;
  const auto shining = tests::addMaterial(s, Number3(0.0), false, {1.0, 2.0, 3.0});
  tests::addQuad(s, {-1, 2, -1}, {2, 0, 0}, {0, 0, 2}, shining);  // looks down
  const Tracer tracer(s);
  const auto e = traceReference(tracer, darkness(), {}, {0, 0, 0}, {0, 1, 0}, {65536, 2, 1});
  checkEstimate(e.local, Number3(1, 2, 3) * (det::kPi * tests::skyViewOfWell(1.0, 2.0, 4)));
  CHECK(traceReference(tracer, darkness(), {}, {0, 4, 0}, {0, -1, 0}, {1024, 2, 1}).local.value == Number3(0.0));
}

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
  Surfaces half;  // up to the middle of the light
  tests::addQuad(half, {1.2, 0, 0}, {0, 9, 0}, {0, 0, 9}, tests::addMaterial(half, Number3(0.0)));
  const LocalLight behind{{1, 4, 3}, Number3(4.0), 0.8};
  const double whole = mean(empty, behind);
  const double part = mean(Tracer(half), behind);
  CHECK(part > 0.6 * whole);
  CHECK(part < 0.9 * whole);
}

TEST_CASE("Reference, NoLightEntersASealedRoom") {
  const sky::Sky sky = tests::clearSky(1.0, 1.2);
  const DistantLight bright(sky, 12.0);
  for (const double azimuth : {0.0, 0.37}) {
    const Number3 moved = azimuth == 0.0 ? Number3(0.0) : Number3(211.3, 17.1, -93.7);
    const auto world = [&](const Number3& p) { return tests::turned(p, azimuth) + moved; };
    const LocalLight lamp[] = {{world({-2, 1, 0.3}), Number3(10.0)}};
    for (const bool open : {true, false}) {
      const Surfaces rooms = tests::turned(tests::twoRooms(Number3(0.8), open), azimuth, moved);
      const Tracer tracer(rooms);
      for (const Number3& p : {Number3(2, 1.5, 0), Number3(0.001, 0.001, -1.999), Number3(3.999, 2.999, 1.999)})
        for (const Number3& normal : kNormals) {
          const auto e = traceReference(tracer, bright, lamp, world(p), normal, {4096, 4, 1});
          CHECK(e.total.value == Number3(0.0));
          CHECK(e.total.standard_error == Number3(0.0));
        }
      const auto lit = traceReference(tracer, bright, lamp, world({-2, 1.5, 0}), {0, 1, 0}, {4096, 4, 1});
      CHECK(lit.local.value.x > 0.1);
      CHECK((lit.sky.value.x > 0.1) == open);
    }
  }
}

TEST_CASE("Reference, LightAndEyeMayChangePlaces") {
  // The light that a point gets from all sides, of a light elsewhere, is that of the light's place from the point.
  const Surfaces level = yard();
  const Tracer tracer(level);
  const Number3 a(-2.1, 0.8, 1.7);
  const Number3 b(2.9, 1.4, -3.1);
  const auto fromAllSides = [&](const Number3& from, const Number3& at) {
    const LocalLight light[] = {{from, Number3(1.0)}};
    constexpr int kNormals = 1000;
    Number3 sum(0.0);
    Number3 squares(0.0);
    for (int i = 0; i < kNormals; ++i) {
      const Number3 normal = sphereDirection((i + 0.5) / kNormals, i * 0.6180339887498949);
      const auto seed = static_cast<std::uint64_t>(i);
      const auto e = traceReference(tracer, darkness(), light, at, normal, {64, 2, seed}).local;
      sum += e.value;
      squares += e.standard_error * e.standard_error;
    }
    Estimate mean{sum / kNormals, {}};
    for (int c = 0; c < 3; ++c) mean.standard_error[c] = std::sqrt(squares[c]) / kNormals;
    return mean;
  };
  const Estimate there = fromAllSides(a, b);
  Estimate difference = fromAllSides(b, a);
  CHECK(there.value.x > 10.0 * there.standard_error.x);
  for (int c = 0; c < 3; ++c)
    difference.standard_error[c] = std::hypot(difference.standard_error[c], there.standard_error[c]);
  checkEstimate(difference, there.value);
}

TEST_CASE("Reference, IsLinearInTheLight") {
  const Surfaces level = yard();
  const Tracer tracer(level);
  const Number3 p(-2.1, 0.8, 1.7);
  const LocalLight lights[] = {{{2, 1, 2}, {4, 2, 1}}, {{-1, 3, 3}, {1, 2, 4}, 0.2}};
  const ReferenceSettings settings{16384, 2, 1};
  sky::Sky sky = tests::clearSky(2.0, 0.9);
  sky.ground_albedo = Number3(0.3);
  const auto once = traceReference(tracer, DistantLight(sky, 0.0), lights, p, kNormals[2], settings);
  for (int c = 0; c < 3; ++c)
    CHECK(once.total.value[c] ==
          Approx(once.sky.value[c] + once.sun_bounce.value[c] + once.local.value[c]).epsilon(1e-12));
  sky.sun.illuminance = sky::Curve::constant(6.0);
  const auto sun_twice = traceReference(tracer, DistantLight(sky, 0.0), lights, p, kNormals[2], settings);
  CHECK(sun_twice.sun_bounce.value == once.sun_bounce.value * 2.0);
  CHECK(sun_twice.sky.value == once.sky.value);
  sky.intensity = sky::Curve::constant(3.0);
  const auto sky_twice = traceReference(tracer, DistantLight(sky, 0.0), lights, p, kNormals[2], settings);
  CHECK(sky_twice.sky.value == once.sky.value * 2.0);
  CHECK(sky_twice.sun_bounce.value == sun_twice.sun_bounce.value);
  CHECK(sky_twice.local.value == once.local.value);
  Estimate sum;
  Number3 squares(0.0);
  for (const LocalLight& light : lights) {
    const auto e = traceReference(tracer, DistantLight(sky, 0.0), {&light, 1}, p, kNormals[2], {16384, 2, 2}).local;
    sum.value += e.value;
    squares += e.standard_error * e.standard_error;
  }
  squares += once.local.standard_error * once.local.standard_error;
  for (int c = 0; c < 3; ++c) sum.standard_error[c] = std::sqrt(squares[c]);
  checkEstimate(sum, once.local.value);
}

TEST_CASE("Reference, LevelAndLightTurnedTogetherLookTheSame") {
  constexpr double kAzimuth = 0.7;
  const Number3 moved(120.0, 7.0, -60.0);
  const Number3 p(-2.1, 0.8, 1.7);
  const LocalLight lamp[] = {{{2, 1, 2}, {4, 2, 1}}};
  const LocalLight turned_lamp[] = {{tests::turned(lamp[0].position, kAzimuth) + moved, lamp[0].intensity}};
  const Surfaces level = yard();
  const Surfaces turned_level = tests::turned(level, kAzimuth, moved);
  const sky::Sky sky = tests::clearSky(2.0, 0.9);
  const sky::Sky turned_sky = tests::clearSky(2.0 + kAzimuth, 0.9);
  const Tracer tracer(level);
  const Tracer turned_tracer(turned_level);
  for (const Number3& normal : kNormals) {
    const auto e = traceReference(tracer, DistantLight(sky, 0.0), lamp, p, normal, {65536, 2, 1});
    const auto turned =
        traceReference(turned_tracer, DistantLight(turned_sky, 0.0), turned_lamp, tests::turned(p, kAzimuth) + moved,
                       tests::turned(normal, kAzimuth), {65536, 2, 2});
    const auto check = [](Estimate a, const Estimate& b) {
      for (int c = 0; c < 3; ++c) a.standard_error[c] = std::hypot(a.standard_error[c], b.standard_error[c]);
      checkEstimate(a, b.value);
    };
    check(turned.sky, e.sky);
    check(turned.sun_bounce, e.sun_bounce);
    check(turned.local, e.local);
  }
}

}  // namespace welkin::probes
