// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/validity.h"

#include <catch2/catch.hpp>

#include "probes/geometry/directions.h"
#include "probes/geometry/random.h"
#include "sh/deterministic.h"
#include "tests/probes/rooms.h"

namespace welkin::tests {

using f64::Number3;
namespace {

bool anywhere(const Number3&) {
  return true;
}

}  // namespace

TEST_CASE("Validity, InsideOutsideAndTooClose") {
  geometry::Surfaces s = groundOf({0.5, 0.5, 0.5});
  addBoxOutside(s, {0, -1, 0}, {2, 3, 2}, 0);
  const geometry::Tracer tracer(s);
  CHECK(placement::placeAt(tracer, {1, 1, 1}, 0.25) == placement::Place::inside);
  CHECK(placement::placeAt(tracer, {1, -0.5, 1}, 0.25) == placement::Place::inside);
  CHECK(placement::placeAt(tracer, {20, -1, 20}, 0.25) == placement::Place::inside);  // under the ground
  CHECK(placement::placeAt(tracer, {2.1, 1, 1}, 0.25) == placement::Place::too_close);
  CHECK(placement::placeAt(tracer, {2.3, 1, 1}, 0.25) == placement::Place::free);
  CHECK(placement::placeAt(tracer, {1, 3.5, 1}, 0.25) == placement::Place::free);
  CHECK(placement::placeAt(tracer, {20, 0.1, 20}, 0.25) == placement::Place::too_close);
}

TEST_CASE("Validity, AQuarterOfAllAroundMayBeBacks") {
  // A square of half width a, seen from a metre behind it, fills asin(a^2 / (a^2 + 1)) / pi of the sphere.
  for (const double share : {0.18, 0.21, 0.29, 0.32}) {
    const double sine = std::sin(share * det::kPi);
    const geometry::Surfaces s = groundOf({0.5, 0.5, 0.5}, std::sqrt(sine / (1.0 - sine)));
    const geometry::Tracer tracer(s);
    CHECK(placement::placeAt(tracer, {0, -1, 0}, 0.25) ==
          (share < 0.25 ? placement::Place::free : placement::Place::inside));
    CHECK(placement::insideGeometry(tracer, {0, -1, 0}) == (share > 0.25));
    CHECK(placement::placeAt(tracer, {0, 1, 0}, 0.25) == placement::Place::free);
  }
}

TEST_CASE("Validity, TwoSidesHaveNoBack") {
  geometry::Surfaces s;
  addBoxOutside(s, {0, 0, 0}, {4, 4, 4}, addMaterial(s, {0.5, 0.5, 0.5}, true));
  const geometry::Tracer tracer(s);
  CHECK(placement::placeAt(tracer, {2, 2, 2}, 0.25) == placement::Place::free);
}

TEST_CASE("Validity, LeavesAreNoWallsButTrunksAreSolid") {
  geometry::Surfaces s = groundOf({0.5, 0.5, 0.5});
  addBoxOutside(s, {0, 0, 0}, {1, 3, 1}, 0);
  s.object.push_back({"tree", geometry::Role::vegetation});
  for (std::size_t i = 2; i < s.triangle.size(); ++i) s.triangle[i].object = 1;
  const geometry::Tracer tracer(s);
  CHECK(placement::placeAt(tracer, {0.5, 1, 0.5}, 0.25) == placement::Place::inside);
  CHECK(placement::placeAt(tracer, {1.1, 1, 0.5}, 0.25) == placement::Place::free);
  CHECK(placement::sees(tracer, {-1, 1, 0.5}, {2, 1, 0.5}));
  CHECK(tracer.occluded({-1, 1, 0.5}, {1, 0, 0}, 3));
  CHECK_FALSE(tracer.occluded({-1, 1, 0.5}, {1, 0, 0}, 3, geometry::Meets::fixed));
  CHECK(tracer.closest({-1, 1, 0.5}, {1, 0, 0}, 3));
  CHECK_FALSE(tracer.closest({-1, 1, 0.5}, {1, 0, 0}, 3, geometry::Meets::fixed));
  CHECK(tracer.occluded({-1, 1, 0.5}, {0, -1, 0}, 3, geometry::Meets::fixed));
}

TEST_CASE("Validity, MovesOutOfABodyToTheNearestFreePlace") {
  geometry::Surfaces s;
  addBoxOutside(s, {0, 0, 0}, {10, 10, 10}, addMaterial(s, {0.5, 0.5, 0.5}));
  const geometry::Tracer tracer(s);
  const placement::Search search = placement::freePlaceNear(tracer, {9.6, 5, 5}, 0.25, anywhere);
  const auto& out = search.found;
  REQUIRE(out);
  CHECK(out->x > 10.25 - 0.01);
  CHECK(placement::distanceOf(*out, {9.6, 5, 5}) <= 1.0);  // the shortest way is 0.65
  const placement::Search vain = placement::freePlaceNear(tracer, {5, 5, 5}, 0.25, anywhere);
  CHECK_FALSE(vain.found);
  // 17 of 64 rays that meet backs tell that a place is inside; the start and 7 spheres of 64 places are asked.
  CHECK(vain.rays == 17 + 7 * 64 * (17 + 1));
  CHECK(search.rays < vain.rays);
  CHECK_FALSE(placement::freePlaceNear(tracer, {9.6, 5, 5}, 0.25, [](const Number3& p) { return p.x < 10; }).found);
}

TEST_CASE("Validity, AWayFromAWallDoesNotCrossIt") {
  geometry::Surfaces s;
  const auto both = addMaterial(s, {0.5, 0.5, 0.5}, true);
  addQuad(s, {0, 0, 0}, {0, 10, 0}, {0, 0, 10}, both);
  const geometry::Tracer tracer(s);
  for (const double x : {-0.05, 0.05}) {
    const auto out = placement::freePlaceNear(tracer, {x, 5, 5}, 0.25, anywhere).found;
    REQUIRE(out);
    CHECK(out->x * x > 0.0);
  }
}

TEST_CASE("Validity, TheClearanceHoldsInEveryDirection") {
  geometry::Random random(3);
  constexpr double kClearance_m = 0.2;
  for (int i = 0; i < 400; ++i) {
    const double s = random.unit();
    const Number3 direction = geometry::sphereDirection(s, random.unit());
    for (const double distance_m : {0.18, 0.2 - 1e-4, 0.2 + 2e-3}) {
      // The tip of a needle. It is thinner than the angles between any fixed set of rays.
      geometry::Surfaces level;
      const Number3 across = cross(direction, Number3(0.3, 0.5, 0.8)) * 1e-3;
      addQuad(level, direction * distance_m, direction + across, direction - across,
              addMaterial(level, Number3(0.5), true));
      const geometry::Tracer tracer(level);
      CHECK(placement::placeAt(tracer, Number3(0.0), kClearance_m) ==
            (distance_m < kClearance_m ? placement::Place::too_close : placement::Place::free));
    }
  }
}

}  // namespace welkin::tests
