// SPDX-License-Identifier: Apache-2.0
// The reference in closed levels, and its invariance to light and place.
#include <catch2/catch.hpp>

#include "probes/geometry/directions.h"
#include "probes/geometry/random.h"
#include "skies.h"
#include "tests/probes/closed_forms/closed_forms.h"

namespace welkin::tests {

using f64::Number3;
namespace {

/// A place without symmetry: a courtyard with a block in it and half a roof.
geometry::Surfaces yard() {
  geometry::Surfaces s = wellOf(4.0, 5.0, 4, {0.6, 0.5, 0.3}, {0.4, 0.6, 0.8});
  const auto block = addMaterial(s, {0.9, 0.3, 0.2});
  addBoxOutside(s, {0.5, 0, -2.5}, {2.2, 2.1, -0.7}, block);
  addQuad(s, {-4, 4, -4}, {8, 0, 0}, {0, 0, 3}, addMaterial(s, {0.7, 0.7, 0.7}, true));
  return s;
}

}  // namespace

TEST_CASE("Reference, AClosedBoxThatShinesIsAFurnaceOfItsBounces") {
  geometry::Surfaces box;
  const Number3 emission(1.5, 0.5, 2.0);
  addBoxInside(box, {-1, 0, -3}, {2, 2.5, 1}, addMaterial(box, kAlbedo, false, emission));
  const geometry::Tracer tracer(box);
  for (const int n : {0, 1, 2, 9})
    for (const Number3& normal : kNormals) {
      const auto e = reference::traceReference(tracer, darkness(), {}, {0.3, 1, -0.4}, normal, {256, n, 1});
      const Number3 ratio = bounces(kAlbedo, 0, n);
      CHECK(ratio.y == Approx((1.0 - std::pow(kAlbedo.y, n + 1)) / (1.0 - kAlbedo.y)));
      checkEstimate(e.local, emission * ratio * det::kPi);
      CHECK(e.local.standard_error.y <= 1e-12);
    }
}

TEST_CASE("Reference, WhiteSurfacesUnderAUniformSkyAreAFurnaceOfAnyShape") {
  geometry::Surfaces level = groundOf(Number3(1.0), kEndless_m);
  addBoxOutside(level, {0.5, 0, -2.5}, {2.2, 2.1, -0.7}, addMaterial(level, Number3(1.0)));
  const geometry::Tracer tracer(level);
  model::Sky sky = uniformSky(1.0);
  sky.ground_albedo = Number3(1.0);
  constexpr int kAll = 100;  // the light loses more than half at every bounce
  for (const Number3& normal : kNormals)
    for (const Number3& p : {Number3(0.2, 0.3, -1), Number3(1, 2.1001, -1), Number3(0.49, 0.01, -0.69)})
      checkEstimate(
          reference::traceReference(tracer, reference::DistantLight(sky, 0.0), {}, p, normal, {1024, kAll, 1}).sky,
          Number3(det::kPi));
}

TEST_CASE("Reference, AShiningSquareHasLambertsIrradiance") {
  geometry::Surfaces s;
  const auto shining = addMaterial(s, Number3(0.0), false, {1.0, 2.0, 3.0});
  addQuad(s, {-1, 2, -1}, {2, 0, 0}, {0, 0, 2}, shining);  // looks down
  const geometry::Tracer tracer(s);
  const auto e = reference::traceReference(tracer, darkness(), {}, {0, 0, 0}, {0, 1, 0}, {65536, 2, 1});
  checkEstimate(e.local, Number3(1, 2, 3) * (det::kPi * skyViewOfWell(1.0, 2.0, 4)));
  CHECK(reference::traceReference(tracer, darkness(), {}, {0, 4, 0}, {0, -1, 0}, {1024, 2, 1}).local.value ==
        Number3(0.0));
}

TEST_CASE("Reference, APointOfASurfaceDoesNotSeeThatSurface") {
  // Slanted and far from the origin, where floats are coarse. The corners of a triangle are farther still.
  geometry::Surfaces level;
  addQuad(level, {400, 17, -400}, {300, 210, 400}, {500, 320, -70}, addMaterial(level, Number3(0.9), true));
  const geometry::Surfaces nothing;
  const geometry::Tracer tracer(level);
  const geometry::Tracer empty(nothing);
  const model::Sky sky = clearSky(1.0, 0.6);
  geometry::Random random(5);
  for (int i = 0; i < 40; ++i) {
    const Number3 above(500 + 250 * random.unit(), 900, -400 + 100 * random.unit());
    const auto hit = tracer.closest(above, {0, -1, 0}, 1000.0);
    REQUIRE(hit);
    const auto at = [&](const geometry::Tracer& t) {
      return reference::traceReference(t, reference::DistantLight(sky, 0.0), {}, hit->position, hit->normal,
                                       {1024, 0, 1})
          .sky.value;
    };
    CHECK(at(tracer) == at(empty));
  }
}

TEST_CASE("Reference, NoLightEntersASealedRoom") {
  const model::Sky sky = clearSky(1.0, 1.2);
  const reference::DistantLight bright(sky, 12.0);
  for (const double azimuth : {0.0, 0.37}) {
    const Number3 moved = azimuth == 0.0 ? Number3(0.0) : Number3(211.3, 17.1, -93.7);
    const auto world = [&](const Number3& p) { return turned(p, azimuth) + moved; };
    const reference::LocalLight lamp[] = {{world({-2, 1, 0.3}), Number3(10.0)}};
    for (const bool open : {true, false}) {
      const geometry::Surfaces rooms = turned(twoRooms(Number3(0.8), open), azimuth, moved);
      const geometry::Tracer tracer(rooms);
      for (const Number3& p : {Number3(2, 1.5, 0), Number3(0.001, 0.001, -1.999), Number3(3.999, 2.999, 1.999)})
        for (const Number3& normal : kNormals) {
          const auto e = reference::traceReference(tracer, bright, lamp, world(p), normal, {4096, 4, 1});
          CHECK(e.total.value == Number3(0.0));
          CHECK(e.total.standard_error == Number3(0.0));
        }
      const auto lit = reference::traceReference(tracer, bright, lamp, world({-2, 1.5, 0}), {0, 1, 0}, {4096, 4, 1});
      CHECK(lit.local.value.x > 0.1);
      CHECK((lit.sky.value.x > 0.1) == open);
    }
  }
}

TEST_CASE("Reference, LightAndEyeMayChangePlaces") {
  // Reciprocity: light from a source to a point, over all sides, equals light from the point to the source.
  const geometry::Surfaces level = yard();
  const geometry::Tracer tracer(level);
  const Number3 a(-2.1, 0.8, 1.7);
  const Number3 b(2.9, 1.4, -3.1);
  const auto fromAllSides = [&](const Number3& from, const Number3& at) {
    const reference::LocalLight light[] = {{from, Number3(1.0)}};
    constexpr int kSides = 1000;
    Number3 sum(0.0);
    Number3 squares(0.0);
    for (int i = 0; i < kSides; ++i) {
      const Number3 normal = geometry::sphereDirection((i + 0.5) / kSides, i * 0.6180339887498949);
      const auto seed = static_cast<std::uint64_t>(i);
      const auto e = reference::traceReference(tracer, darkness(), light, at, normal, {64, 2, seed}).local;
      sum += e.value;
      squares += e.standard_error * e.standard_error;
    }
    reference::Estimate mean{sum / kSides, {}};
    for (int c = 0; c < 3; ++c) mean.standard_error[c] = std::sqrt(squares[c]) / kSides;
    return mean;
  };
  const reference::Estimate there = fromAllSides(a, b);
  reference::Estimate difference = fromAllSides(b, a);
  CHECK(there.value.x > 10.0 * there.standard_error.x);
  for (int c = 0; c < 3; ++c)
    difference.standard_error[c] = std::hypot(difference.standard_error[c], there.standard_error[c]);
  checkEstimate(difference, there.value);
}

TEST_CASE("Reference, IsLinearInTheLight") {
  const geometry::Surfaces level = yard();
  const geometry::Tracer tracer(level);
  const Number3 p(-2.1, 0.8, 1.7);
  const reference::LocalLight lights[] = {{{2, 1, 2}, {4, 2, 1}}, {{-1, 3, 3}, {1, 2, 4}, 0.2}};
  const reference::ReferenceSettings settings{16384, 2, 1};
  model::Sky sky = clearSky(2.0, 0.9);
  sky.ground_albedo = Number3(0.3);
  const auto once =
      reference::traceReference(tracer, reference::DistantLight(sky, 0.0), lights, p, kNormals[2], settings);
  for (int c = 0; c < 3; ++c)
    CHECK(once.total.value[c] ==
          Approx(once.sky.value[c] + once.sun_bounce.value[c] + once.local.value[c]).epsilon(1e-12));
  sky.sun.illuminance = base::Curve::constant(6.0);
  const auto sun_twice =
      reference::traceReference(tracer, reference::DistantLight(sky, 0.0), lights, p, kNormals[2], settings);
  CHECK(sun_twice.sun_bounce.value == once.sun_bounce.value * 2.0);
  CHECK(sun_twice.sky.value == once.sky.value);
  sky.intensity = base::Curve::constant(3.0);
  const auto sky_twice =
      reference::traceReference(tracer, reference::DistantLight(sky, 0.0), lights, p, kNormals[2], settings);
  CHECK(sky_twice.sky.value == once.sky.value * 2.0);
  CHECK(sky_twice.sun_bounce.value == sun_twice.sun_bounce.value);
  CHECK(sky_twice.local.value == once.local.value);
  reference::Estimate sum;
  Number3 squares(0.0);
  for (const reference::LocalLight& light : lights) {
    const auto e =
        reference::traceReference(tracer, reference::DistantLight(sky, 0.0), {&light, 1}, p, kNormals[2], {16384, 2, 2})
            .local;
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
  const reference::LocalLight lamp[] = {{{2, 1, 2}, {4, 2, 1}}};
  const reference::LocalLight turned_lamp[] = {{turned(lamp[0].position, kAzimuth) + moved, lamp[0].intensity}};
  const geometry::Surfaces level = yard();
  const geometry::Surfaces turned_level = turned(level, kAzimuth, moved);
  const model::Sky sky = clearSky(2.0, 0.9);
  const model::Sky turned_sky = clearSky(2.0 + kAzimuth, 0.9);
  const geometry::Tracer tracer(level);
  const geometry::Tracer turned_tracer(turned_level);
  for (const Number3& normal : kNormals) {
    const auto e = reference::traceReference(tracer, reference::DistantLight(sky, 0.0), lamp, p, normal, {65536, 2, 1});
    const auto rotated =
        reference::traceReference(turned_tracer, reference::DistantLight(turned_sky, 0.0), turned_lamp,
                                  turned(p, kAzimuth) + moved, turned(normal, kAzimuth), {65536, 2, 2});
    const auto check = [](reference::Estimate a, const reference::Estimate& b) {
      for (int c = 0; c < 3; ++c) a.standard_error[c] = std::hypot(a.standard_error[c], b.standard_error[c]);
      checkEstimate(a, b.value);
    };
    check(rotated.sky, e.sky);
    check(rotated.sun_bounce, e.sun_bounce);
    check(rotated.local, e.local);
  }
}

}  // namespace welkin::tests
