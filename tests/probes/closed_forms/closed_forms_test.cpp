// SPDX-License-Identifier: Apache-2.0
#include "closed_forms.h"

#include <catch2/catch.hpp>
#include <limits>

#include "probes/geometry/directions.h"
#include "probes/geometry/random.h"
#include "probes/geometry/tracer.h"

namespace welkin::tests {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// Share of cosine-distributed rays from the ground that leave the level; no surface may show them its back.
double openShare(const geometry::Surfaces& s) {
  const geometry::Tracer tracer(s);
  geometry::Random random(1);
  constexpr int kRays = 40000;
  int open = 0;
  for (int i = 0; i < kRays; ++i) {
    const double u = random.unit();
    const auto hit = tracer.closest({0, 1e-4, 0}, geometry::cosineDirection({0, 1, 0}, u, random.unit()), kFar);
    if (!hit) ++open;
    REQUIRE((!hit || !hit->back));
  }
  return static_cast<double>(open) / kRays;
}

constexpr double kFourStandardErrors = 4.0 * 0.5 / 200.0;  // for a share of 40000 rays, at most

}  // namespace

TEST_CASE("ClosedForms, LevelsHaveTheirSkyViewFactor") {
  const Number3 black(0.0);
  for (const double g : {0.3, 0.8, 1.3})
    CHECK(openShare(wallTo(g, black, black)) == Approx(skyViewOfWall(g)).margin(kFourStandardErrors));
  for (const double h : {2.0, 8.0, 20.0})
    CHECK(openShare(canyonOf(8.0, h, black, black)) == Approx(skyViewOfCanyon(8.0, h)).margin(kFourStandardErrors));
  for (const int sides : {3, 4, 256})
    CHECK(openShare(wellOf(3.0, 4.0, sides, black, black)) ==
          Approx(skyViewOfWell(3.0, 4.0, sides)).margin(kFourStandardErrors));
}

TEST_CASE("ClosedForms, AWellOfFourSidesIsTheCourtyardAndOneOfManyIsRound") {
  CHECK(skyViewOfWell(1.0, 1.0, 4) == Approx(0.5541).margin(5e-5));
  CHECK(skyViewOfWell(1.0, 2.0, 4) == Approx(0.23946).margin(5e-6));
  CHECK(skyViewOfWell(1.0, 4.0, 4) == Approx(0.07348).margin(5e-6));
  for (const double h : {0.5, 1.0, 3.0})
    CHECK(skyViewOfWell(1.0, h, 256) == Approx(skyViewOfRoundWell(1.0, h)).margin(3e-5));
}

TEST_CASE("ClosedForms, TheSphereIsClosedAndOfItsArea") {
  const geometry::Surfaces s = sphereInside(5.0, 3, Number3(0.5));
  CHECK(s.triangle.size() == 1280);
  CHECK(openShare(s) == 0.0);
  double area = 0.0;
  const auto load = [&](std::uint32_t i) {
    const auto& p = s.position[i];
    return Number3(double{p[0]}, double{p[1]}, double{p[2]});
  };
  for (const auto& t : s.triangle) {
    const Number3 a = load(t.vertex[0]);
    const Number3 normal = cross(load(t.vertex[1]) - a, load(t.vertex[2]) - a);
    area += 0.5 * std::sqrt(dot(normal, normal));
  }
  CHECK(area == Approx(4.0 * det::kPi * 25.0).epsilon(1e-6));
  CHECK(roughnessOf(s, 5.0) < 0.006);
  CHECK(roughnessOf(sphereInside(5.0, 4, Number3(0.5)), 5.0) < 0.0015);
}

TEST_CASE("ClosedForms, NoRayPassesBetweenTheTwoRoomsTurnedOffTheAxesToo") {
  for (const double azimuth : {0.0, 0.37}) {
    const Number3 moved = azimuth == 0.0 ? Number3(0.0) : Number3(211.3, 17.1, -93.7);
    const geometry::Surfaces s = turned(twoRooms(Number3(0.5), true), azimuth, moved);
    const geometry::Tracer tracer(s);
    geometry::Random random(2);
    int open = 0;
    for (int i = 0; i < 20000; ++i) {
      const double u = random.unit();
      const Number3 w = geometry::sphereDirection(u, random.unit());
      REQUIRE(tracer.occluded(turned(Number3(2, 1.3, 0.5), azimuth) + moved, w, kFar));
      open += tracer.occluded(turned(Number3(-2, 1.3, 0.5), azimuth) + moved, w, kFar) ? 0 : 1;
    }
    CHECK(open > 3000);
  }
}

}  // namespace welkin::tests
