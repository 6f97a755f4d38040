// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/validity.h"

#include <catch2/catch.hpp>

#include "rooms.h"
#include "sh/deterministic.h"

namespace welkin::probes {
namespace {

bool anywhere(const Number3&) {
  return true;
}

}  // namespace

TEST_CASE("Validity, InsideOutsideAndTooClose") {
  Surfaces s = tests::groundOf({0.5, 0.5, 0.5});
  tests::addBoxOutside(s, {0, -1, 0}, {2, 3, 2}, 0);
  const Tracer tracer(s);
  CHECK(placeAt(tracer, {1, 1, 1}, 0.25) == Place::inside);
  CHECK(placeAt(tracer, {1, -0.5, 1}, 0.25) == Place::inside);
  CHECK(placeAt(tracer, {20, -1, 20}, 0.25) == Place::inside);  // under the ground
  CHECK(placeAt(tracer, {2.1, 1, 1}, 0.25) == Place::too_close);
  CHECK(placeAt(tracer, {2.3, 1, 1}, 0.25) == Place::free);
  CHECK(placeAt(tracer, {1, 3.5, 1}, 0.25) == Place::free);
  CHECK(placeAt(tracer, {20, 0.1, 20}, 0.25) == Place::too_close);
}

TEST_CASE("Validity, AQuarterOfAllAroundMayBeBacks") {
  // A square of half width a, seen from a metre behind it, fills asin(a^2 / (a^2 + 1)) / pi of the sphere.
  for (const double share : {0.18, 0.21, 0.29, 0.32}) {
    const double sine = std::sin(share * det::kPi);
    const Surfaces s = tests::groundOf({0.5, 0.5, 0.5}, std::sqrt(sine / (1.0 - sine)));
    const Tracer tracer(s);
    CHECK(placeAt(tracer, {0, -1, 0}, 0.25) == (share < 0.25 ? Place::free : Place::inside));
    CHECK(insideGeometry(tracer, {0, -1, 0}) == (share > 0.25));
    CHECK(placeAt(tracer, {0, 1, 0}, 0.25) == Place::free);
  }
}

TEST_CASE("Validity, TwoSidesHaveNoBack") {
  Surfaces s;
  tests::addBoxOutside(s, {0, 0, 0}, {4, 4, 4}, tests::addMaterial(s, {0.5, 0.5, 0.5}, true));
  const Tracer tracer(s);
  CHECK(placeAt(tracer, {2, 2, 2}, 0.25) == Place::free);
}

TEST_CASE("Validity, LeavesAreNoWallsButTrunksAreSolid") {
  Surfaces s = tests::groundOf({0.5, 0.5, 0.5});
  tests::addBoxOutside(s, {0, 0, 0}, {1, 3, 1}, 0);
  s.object.push_back({"tree", Role::vegetation});
  for (std::size_t i = 2; i < s.triangle.size(); ++i) s.triangle[i].object = 1;
  const Tracer tracer(s);
  CHECK(placeAt(tracer, {0.5, 1, 0.5}, 0.25) == Place::inside);
  CHECK(placeAt(tracer, {1.1, 1, 0.5}, 0.25) == Place::free);
  CHECK(sees(tracer, {-1, 1, 0.5}, {2, 1, 0.5}));
  CHECK(tracer.occluded({-1, 1, 0.5}, {1, 0, 0}, 3));
  CHECK_FALSE(tracer.occluded({-1, 1, 0.5}, {1, 0, 0}, 3, Meets::fixed));
  CHECK(tracer.closest({-1, 1, 0.5}, {1, 0, 0}, 3));
  CHECK_FALSE(tracer.closest({-1, 1, 0.5}, {1, 0, 0}, 3, Meets::fixed));
  CHECK(tracer.occluded({-1, 1, 0.5}, {0, -1, 0}, 3, Meets::fixed));
}

TEST_CASE("Validity, MovesOutOfABodyToTheNearestFreePlace") {
  Surfaces s;
  tests::addBoxOutside(s, {0, 0, 0}, {10, 10, 10}, tests::addMaterial(s, {0.5, 0.5, 0.5}));
  const Tracer tracer(s);
  const auto out = freePlaceNear(tracer, {9.6, 5, 5}, 0.25, anywhere);
  REQUIRE(out);
  CHECK(out->x > 10.25 - 0.01);
  CHECK(distanceOf(*out, {9.6, 5, 5}) <= 1.0);  // 0.65 is the shortest way
  CHECK_FALSE(freePlaceNear(tracer, {5, 5, 5}, 0.25, anywhere));
  CHECK_FALSE(freePlaceNear(tracer, {9.6, 5, 5}, 0.25, [](const Number3& p) { return p.x < 10; }));
}

TEST_CASE("Validity, AWayFromAWallDoesNotCrossIt") {
  Surfaces s;
  const auto both = tests::addMaterial(s, {0.5, 0.5, 0.5}, true);
  tests::addQuad(s, {0, 0, 0}, {0, 10, 0}, {0, 0, 10}, both);
  const Tracer tracer(s);
  for (const double x : {-0.05, 0.05}) {
    const auto out = freePlaceNear(tracer, {x, 5, 5}, 0.25, anywhere);
    REQUIRE(out);
    CHECK(out->x * x > 0.0);
  }
}

}  // namespace welkin::probes
