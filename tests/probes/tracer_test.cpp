// SPDX-License-Identifier: Apache-2.0
#include "probes/geometry/tracer.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "probes/geometry/directions.h"
#include "probes/geometry/random.h"
#include "tests/probes/closed_forms/closed_forms.h"

namespace welkin::tests {

using f64::Number3;
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("Tracer, FindsTheNearestSurfaceAndItsSide") {
  geometry::Surfaces s;
  const auto red = addMaterial(s, {0.9, 0.1, 0.2});
  const auto both = addMaterial(s, {0.5, 0.5, 0.5}, true);
  addQuad(s, {-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, red);  // looks up
  addQuad(s, {-1, 3, -1}, {0, 0, 2}, {2, 0, 0}, both);
  const geometry::Tracer tracer(s);
  const auto down = tracer.closest({0.25, 2, 0.5}, {0, -1, 0}, kFar);
  REQUIRE(down);
  CHECK(down->distance == Approx(2.0));
  CHECK(down->normal == Number3(0, 1, 0));
  CHECK_FALSE(down->back);
  CHECK(down->position.x == Approx(0.25));
  CHECK(down->position.z == Approx(0.5));
  CHECK(tracer.albedo(*down) == Number3(0.9, 0.1, 0.2));
  const auto below = tracer.closest({0.25, -2, 0.5}, {0, 1, 0}, kFar);
  REQUIRE(below);
  CHECK(below->back);
  CHECK(tracer.albedo(*below) == Number3(0.0));
  const auto up = tracer.closest({0.25, 2, 0.5}, {0, 1, 0}, kFar);
  REQUIRE(up);
  CHECK(up->normal == Number3(0, -1, 0));
  CHECK_FALSE(up->back);
  CHECK_FALSE(tracer.closest({0.25, 2, 0.5}, {0, -1, 0}, 1.99));
  CHECK(tracer.occluded({0.25, 2, 0.5}, {0, -1, 0}, 2.01));
  CHECK_FALSE(tracer.occluded({0.25, 2, 0.5}, {0, -1, 0}, 1.99));
  CHECK_FALSE(tracer.occluded({0.25, 2, 0.5}, {1, 0, 0}, kFar));
}

TEST_CASE("Tracer, MeetsABackWhereTheNearestSurfaceShowsOne") {
  geometry::Surfaces s;
  addQuad(s, {-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, addMaterial(s, {0.9, 0.1, 0.2}));  // looks up
  addQuad(s, {-1, -4, -1}, {0, 0, 2}, {2, 0, 0}, addMaterial(s, {0.5, 0.5, 0.5}, true));
  addQuad(s, {3, -2, -2}, {0, 4, 1}, {1, 0, 4}, addMaterial(s, {0.5, 0.5, 0.5}));
  const geometry::Tracer tracer(s);
  CHECK(tracer.meetsBack({0.25, -2, 0.5}, {0, 1, 0}, kFar));
  CHECK_FALSE(tracer.meetsBack({0.25, -2, 0.5}, {0, 1, 0}, 1.99));
  CHECK_FALSE(tracer.meetsBack({0.25, 2, 0.5}, {0, -1, 0}, kFar));   // a front
  CHECK_FALSE(tracer.meetsBack({0.25, -6, 0.5}, {0, 1, 0}, kFar));   // two sides
  CHECK_FALSE(tracer.meetsBack({0.25, -2, 0.5}, {0, -1, 0}, kFar));  // two sides
  geometry::Random random(7);
  std::size_t backs = 0;
  for (int i = 0; i < 2000; ++i) {
    const double u = random.unit(), v = random.unit();
    const Number3 from(6.0 * u - 2.0, 6.0 * v - 5.0, random.unit());
    const double s1 = random.unit(), t1 = random.unit();
    const Number3 direction = geometry::sphereDirection(s1, t1);
    const auto hit = tracer.closest(from, direction, kFar);
    const bool back = hit && hit->back;
    backs += back ? 1 : 0;
    CHECK(tracer.meetsBack(from, direction, kFar) == back);
  }
  CHECK(backs > 50);
}

TEST_CASE("Tracer, CornersAreRoundedAsEmbreeHasThem") {
  // GCC 12 can take double{static_cast<float>(x)} for x in a vector of two. 29.9 and 31.7 are no floats.
  for (const double far : {29.9, 31.7})
    for (int axis = 0; axis < 3; ++axis) {
      Number3 corner(-1.0), towards(0.0);
      corner[axis] = far;
      towards[axis] = 1.0;
      geometry::Surfaces s;
      Number3 one(0.0), other(0.0);
      one[(axis + 1) % 3] = 2.0;
      other[(axis + 2) % 3] = 2.0;
      addQuad(s, corner, one, other, addMaterial(s, Number3(0.5), true));
      const auto hit = geometry::Tracer(s, Number3(0.0)).closest(towards, towards, kFar);
      REQUIRE(hit);
      CHECK(hit->coarsest_m == double{static_cast<float>(far)});
      CHECK(hit->position[axis] == double{static_cast<float>(far)});
    }
}

TEST_CASE("Tracer, SeesNoFartherThanItsSquare") {
  geometry::Surfaces s;
  const auto material = addMaterial(s, {0.5, 0.5, 0.5}, true);
  addQuad(s, {20, -50, -50}, {0, 0, 100}, {0, 100, 0}, material);   // x = 20
  addQuad(s, {-50, -50, -30}, {100, 0, 0}, {0, 100, 0}, material);  // z = -30
  addQuad(s, {-50, 40, -50}, {0, 0, 100}, {100, 0, 0}, material);   // y = 40
  const geometry::Tracer whole(s);
  const geometry::Tracer tracer = whole.within({8, 500, -12}, 10.0);  // x -2 to 18, z -22 to -2
  const Number3 at(8, 0, -12);
  for (const Number3& direction : {Number3(1, 0, 0), Number3(0, 0, -1)}) {
    CHECK(whole.closest(at, direction, kFar));
    CHECK_FALSE(tracer.closest(at, direction, kFar));
    CHECK_FALSE(tracer.occluded(at, direction, kFar));
  }
  CHECK(tracer.occluded(at, {0, 1, 0}, kFar));
  CHECK(tracer.closest(at, {0, 1, 0}, kFar)->distance == Approx(40.0));
  CHECK_FALSE(tracer.occluded(at, {0, 1, 0}, 39.0));
  CHECK(whole.within(at, 12.5).occluded(at, {1, 0, 0}, kFar));

  CHECK(tracer.leavesAfter(at, {1, 0, 0}) == 10.0);
  CHECK(tracer.leavesAfter({0, 0, -12}, {-1, 0, 0}) == 2.0);
  CHECK(tracer.leavesAfter({0, 0, -20}, {0, 0, -1}) == 2.0);
  CHECK(tracer.leavesAfter({0, 0, -20}, {0, 0, 1}) == 18.0);
  CHECK(tracer.leavesAfter({0, 0, -20}, {-0.6, 0, 0.8}) == Approx(2.0 / 0.6));
  CHECK(tracer.leavesAfter(at, {0, -1, 0}) == kFar);
  CHECK(tracer.leavesAfter(at, {-0.0, 1, -0.0}) == kFar);
  CHECK(tracer.leavesAfter({18, 0, -12}, {1, 0, 0}) == 0.0);
  CHECK(tracer.leavesAfter({18, 0, -12}, {0, 0, 1}) == 10.0);
  CHECK(tracer.leavesAfter({19, 0, -12}, {1, 0, 0}) == 0.0);  // off a surface on the square's edge
  CHECK(whole.leavesAfter(at, {1, 0, 0}) == kFar);
}

TEST_CASE("Tracer, MaskedTexelsLetRaysThrough") {
  geometry::Surfaces s;
  const auto leaf = addMaterial(s, {1, 1, 1}, true);
  s.texture.push_back({2,
                       1,
                       {255, 255, 255, 255, 255, 255, 255, 0},
                       geometry::Texture::Wrap::clamped,
                       geometry::Texture::Wrap::clamped});
  s.material[leaf].texture = 0;
  s.material[leaf].alpha_cutoff = 0.5;
  addQuad(s, {0, 1, 0}, {0, 0, 4}, {4, 0, 0}, leaf);
  s.uv = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};  // u along x
  const geometry::Tracer tracer(s);
  CHECK(tracer.occluded({0.5, 0, 2}, {0, 1, 0}, kFar));
  CHECK_FALSE(tracer.occluded({3.5, 0, 2}, {0, 1, 0}, kFar));
  CHECK(tracer.closest({1.9, 0, 2}, {0, 1, 0}, kFar));
  CHECK_FALSE(tracer.closest({2.1, 0, 2}, {0, 1, 0}, kFar));
}

TEST_CASE("Tracer, ARayThatLeavesASurfaceDoesNotMeetItAgain") {
  // A slanted surface far from the origin, where floats are coarse: the origin's rounding is 3e-5 m there.
  geometry::Surfaces s;
  const auto grey = addMaterial(s, {0.5, 0.5, 0.5}, true);
  addQuad(s, {400, 17, -400}, {3, 1, 40}, {50, 2, -7}, grey);
  const geometry::Tracer tracer(s);
  geometry::Random random(7);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const Number3 origin(410 + 30 * random.unit(), 60, -400 + 30 * random.unit());
    const Number3 direction = geometry::unit(Number3(random.unit() - 0.5, -1, random.unit() - 0.5));
    const auto hit = tracer.closest(origin, direction, kFar);
    if (!hit) continue;
    ++hits;
    const Number3 away = geometry::unit(
        hit->normal + geometry::unit(Number3(random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5)) * 0.999);
    CHECK_FALSE(tracer.occluded(tracer.leaving(*hit), away, kFar));
  }
  CHECK(hits > 5000);
}

TEST_CASE("Tracer, ARayThatLeavesACornerStaysInTheRoom") {
  // Rays aim at the edges, within the rounding of floats. An origin on an edge has one wall behind it or in front.
  for (const double azimuth : {0.0, 0.37}) {
    const Number3 moved = azimuth == 0.0 ? Number3(0.0) : Number3(211.3, 17.1, -93.7);
    const auto world = [&](const Number3& p) { return turned(p, azimuth) + moved; };
    const geometry::Surfaces rooms = turned(twoRooms(Number3(0.5), true), azimuth, moved);
    const geometry::Tracer tracer(rooms);
    geometry::Random random(11);
    const Number3 eye = world({1.9, 1.4, 0.3});
    for (int i = 0; i < 20000; ++i) {
      const auto aside = [&] { return 2e-5 * (random.unit() - 0.5); };
      const Number3 edge =
          i % 2 == 0 ? Number3(0.0, 0.0, 4.0 * random.unit() - 2.0) : Number3(0, 3.0 * random.unit(), 2);
      const auto hit =
          tracer.closest(eye, geometry::unit(world(edge + Number3(aside(), aside(), aside())) - eye), kFar);
      REQUIRE(hit);
      const double s = random.unit();
      const Number3 away = geometry::cosineDirection(hit->normal, s, random.unit());
      REQUIRE(tracer.closest(tracer.leaving(*hit), away, kFar));
    }
  }
}

TEST_CASE("Tracer, ARayThatLeavesALargeSurfaceDoesNotMeetItAgain") {
  // Floats are fine near the origin, but not at the corners, 4 km away: an oblique wall 8 km long.
  const geometry::Surfaces s = turned(wallTo(0.8, Number3(0.5), Number3(0.5)), 2.1);
  const geometry::Tracer tracer(s);
  geometry::Random random(3);
  int hits = 0;
  for (int i = 0; i < 5000; ++i) {
    const Number3 direction = turned(geometry::unit(Number3(random.unit() - 0.5, 0.5 * random.unit(), -1)),
                                     2.1);  // from the origin to the wall
    const auto hit = tracer.closest({0, 1, 0}, direction, kFar);
    if (!hit) continue;
    ++hits;
    const Number3 away =
        geometry::unit(hit->normal + geometry::unit(Number3(random.unit() - 0.5, 1.0, random.unit() - 0.5)) * 0.9);
    CHECK_FALSE(tracer.occluded(tracer.leaving(*hit), away, kFar));
  }
  CHECK(hits == 5000);
}

TEST_CASE("Tracer, NearnessIsThatOfTheNearestOfManyPoints") {
  geometry::Random random(11);
  const auto somewhere = [&] {
    const double x = random.unit();
    const double y = random.unit();
    return Number3(x, y, random.unit()) * 2.0;
  };
  for (int i = 0; i < 60; ++i) {
    geometry::Surfaces s;
    const Number3 corner = somewhere();
    const Number3 a = somewhere() - Number3(1.0);
    const Number3 b = somewhere() - Number3(1.0);
    addQuad(s, corner, a, b, addMaterial(s, Number3(0.5)));
    s.triangle.pop_back();  // the triangle corner, corner + a, corner + a + b
    const geometry::Tracer tracer(s);
    const Number3 p = somewhere();
    double nearest = 1e9;
    constexpr int kSteps = 400;
    for (int u = 0; u <= kSteps; ++u)
      for (int v = 0; v <= u; ++v) {
        const Number3 way = corner + a * (static_cast<double>(u) / kSteps) + b * (static_cast<double>(v) / kSteps) - p;
        nearest = std::min(nearest, std::sqrt(dot(way, way)));
      }
    constexpr double kStep_m = 0.009;  // half a diagonal of the sampled lattice, at most
    CHECK(tracer.isNearer(p, nearest + 1e-6));
    CHECK_FALSE(tracer.isNearer(p, nearest - kStep_m));
  }
}

TEST_CASE("Tracer, OnlyStaticGeometryIsNear") {
  geometry::Surfaces s = groundOf(Number3(0.5), 10.0);
  s.object.push_back({"leaf", geometry::Role::vegetation});
  addQuad(s, {-1, 2, -1}, {0, 0, 2}, {2, 0, 0}, 0);
  for (std::size_t i = 2; i < s.triangle.size(); ++i) s.triangle[i].object = 1;
  const geometry::Tracer tracer(s);
  CHECK_FALSE(tracer.isNearer({0, 1.9, 0}, 0.5));
  CHECK(tracer.isNearer({0, 1.9, 0}, 2.0));
}

TEST_CASE("Tracer, AllSurfacesOfARayAreThoseOfASearchThroughAllTriangles") {
  geometry::Random random(11);
  geometry::Surfaces s;
  addMaterial(s, Number3(0.5));
  s.object.push_back({"walls", geometry::Role::fixed});
  s.object.push_back({"leaves", geometry::Role::vegetation});
  constexpr std::uint32_t kTriangles = 400;
  for (std::uint32_t i = 0; i < kTriangles; ++i) {
    for (int corner = 0; corner < 3; ++corner) {
      const double x = 64.0 * random.unit();
      const double y = 64.0 * random.unit();
      s.position.push_back({x, y, 64.0 * random.unit()});
    }
    s.triangle.push_back({{3 * i, 3 * i + 1, 3 * i + 2}, 0, i % 2});
  }
  const geometry::Tracer tracer(s);
  for (const double x : {20.03, 31.71, 40.4}) {
    const Number3 from(x, 60.0, 31.3);
    std::vector<std::pair<double, std::uint32_t>> expected;  // distance, triangle
    for (std::uint32_t i = 0; i < kTriangles; ++i) {
      const auto corner = [&](std::size_t n) {
        const auto& p = s.position[s.triangle[i].vertex[n]];
        return Number3(p[0], p[1], p[2]);
      };
      const Number3 a = corner(0) - from, ab = corner(1) - corner(0), ac = corner(2) - corner(0);
      const double area = ab.x * ac.z - ab.z * ac.x;
      const double u = (a.z * ac.x - a.x * ac.z) / area;
      const double v = (a.x * ab.z - a.z * ab.x) / area;
      const double distance = -(a.y + u * ab.y + v * ac.y);
      if (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance >= 0.0) expected.emplace_back(distance, i);
    }
    std::sort(expected.begin(), expected.end());
    REQUIRE(expected.size() > 20);
    const auto check = [&](const std::vector<geometry::Hit>& hits, double far, bool fixed_only) {
      std::size_t n = 0;
      for (const auto& [distance, triangle] : expected) {
        if (distance > far || (fixed_only && triangle % 2 == 1)) continue;
        REQUIRE(n < hits.size());
        CHECK(hits[n].triangle == triangle);
        CHECK(hits[n].distance == Approx(distance).margin(1e-3));  // floats; steep triangles
        ++n;
      }
      CHECK(n == hits.size());
    };
    check(tracer.all(from, {0, -1, 0}, kFar), kFar, false);
    check(tracer.all(from, {0, -1, 0}, 30.0), 30.0, false);
    check(tracer.all(from, {0, -1, 0}, kFar, geometry::Meets::fixed), kFar, true);
    const auto near = tracer.within(from, 5.0).all(from, {1, 0, 0}, kFar);
    CHECK(near.size() < tracer.all(from, {1, 0, 0}, kFar).size());
    for (const geometry::Hit& hit : near) CHECK(hit.distance <= 5.0);
  }
}

}  // namespace welkin::tests
