// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/placement.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "placed.h"
#include "probes/geometry/random.h"
#include "probes/placement/candidates.h"
#include "probes/placement/column.h"
#include "probes/placement/validity.h"

namespace welkin::tests {

using f64::Number3;
namespace {

double leastSeparation(const geometry::PlacedSector& sector) {
  double least = 1e9;
  for (std::size_t i = 0; i < sector.probe.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      least = std::min(least, placement::distanceOf(sector.probe[i].position, sector.probe[j].position));
  return least;
}

/// Random triangles across a sector.
geometry::Surfaces soupOf(std::uint32_t triangles) {
  geometry::Random random(7);
  geometry::Surfaces s;
  addMaterial(s, Number3(0.5));
  s.object.push_back({"soup", geometry::Role::fixed});
  for (std::uint32_t i = 0; i < triangles; ++i) {
    for (int corner = 0; corner < 3; ++corner) {
      const double x = 64.0 * random.unit();
      const double y = 64.0 * random.unit();
      s.position.push_back({x, y, 64.0 * random.unit()});
    }
    s.triangle.push_back({{3 * i, 3 * i + 1, 3 * i + 2}, 0, 0});
  }
  return s;
}

}  // namespace

TEST_CASE("Placement, OpenGroundHasAProbeEveryEightMetres") {
  placement::PlacementReport report;
  const geometry::PlacedSector sector = place(groundOf({0.5, 0.5, 0.5}), {0, 0}, {}, &report);
  CHECK(sector.probe.size() == 64);
  CHECK(leastSeparation(sector) == Approx(8.0));
  for (const geometry::Probe& p : sector.probe) {
    CHECK(p.position.y == 1.0);
    CHECK(geometry::sectorAt(p.position) == geometry::SectorId{0, 0});
  }
  CHECK(report.columns == 256);
  CHECK(report.walkable == 256 + 1024);
  CHECK(report.near_others == 192);
  CHECK(report.added_for_sight == 0);
  CHECK(report.uncovered.empty());
  CHECK(report.moved.empty());
  CHECK(report.dropped.empty());
  CHECK(sector.low_y == 0.0);
  CHECK(sector.cell_height_m == 4.0);
}

TEST_CASE("Placement, NeighboursContinueTheLattice") {
  const geometry::Surfaces s = groundOf({0.5, 0.5, 0.5});
  const geometry::PlacedSector west = place(s, {-1, -3});
  const geometry::PlacedSector east = place(s, {0, -3});
  REQUIRE(west.probe.size() == east.probe.size());
  for (std::size_t i = 0; i < west.probe.size(); ++i)
    CHECK(placement::distanceOf(west.probe[i].position + Number3(64, 0, 0), east.probe[i].position) < 1e-12);
  CHECK((west.grid == east.grid));
}

TEST_CASE("Placement, FollowsASlope") {
  geometry::Surfaces s;
  addQuad(s, {-100, -50, -100}, {0, 0, 200}, {200, 100, 0}, addMaterial(s, {0.5, 0.5, 0.5}));
  placement::PlacementReport report;
  const geometry::PlacedSector sector = place(s, {0, 0}, {}, &report);
  CHECK(sector.probe.size() >= 64);
  for (const geometry::Probe& p : sector.probe) CHECK(p.position.y == Approx(0.5 * p.position.x + 1.0).margin(1e-4));
  CHECK(leastSeparation(sector) >= 7.0);
  CHECK(report.uncovered.empty());
}

TEST_CASE("Placement, FloorsUnderRoofsHaveTheirOwn") {
  geometry::Surfaces s = groundOf({0.5, 0.5, 0.5});
  addBoxOutside(s, {8, 3, 8}, {56, 3.3, 56}, 0);
  addBoxOutside(s, {8, 6.3, 8}, {56, 6.6, 56}, 0);
  placement::PlacementReport report;
  const geometry::PlacedSector sector = place(s, {0, 0}, {}, &report);
  CHECK(countBetween(sector, 0, 2) == 64);
  CHECK(countBetween(sector, 4.2, 4.4) >= 36);
  CHECK(countBetween(sector, 7.5, 7.7) >= 36);
  CHECK(report.uncovered.empty());
}

TEST_CASE("Placement, ACrawlSpaceIsNoGroundAndALowRoomGetsItsMiddle") {
  geometry::Surfaces s = groundOf({0.5, 0.5, 0.5});
  addBoxOutside(s, {-200, 1.5, -200}, {32, 2, 200}, 0);
  addBoxOutside(s, {32, 1.1, -200}, {200, 2, 200}, 0);
  placement::PlacementReport report;
  const geometry::PlacedSector sector = place(s, {0, 0}, {}, &report);
  CHECK(report.low == 128);
  CHECK(report.ground == 128 + 256);
  CHECK(countBetween(sector, 0.0, 2.0) == countBetween(sector, 0.749, 0.751));
  CHECK(countBetween(sector, 0.0, 2.0) == 32);
}

TEST_CASE("Placement, GroundUnderWaterIsNone") {
  // The western half lies 2 m under water, with leaves between. A roof over the east, and water on it, change nothing
  // there.
  geometry::Surfaces s = groundOf(Number3(0.3), 100.0);
  const auto both = addMaterial(s, Number3(0.5), true);
  s.object.push_back({"lake", geometry::Role::water});
  s.object.push_back({"palm", geometry::Role::vegetation});
  const auto addAs = [&](std::uint32_t object, const Number3& corner, const Number3& a, const Number3& b) {
    const std::size_t first = s.triangle.size();
    addQuad(s, corner, a, b, both);
    for (std::size_t i = first; i < s.triangle.size(); ++i) s.triangle[i].object = object;
  };
  addAs(1, {-100, 2, -100}, {0, 0, 200}, {132, 0, 0});
  addAs(2, {0, 1.5, 0}, {0, 0, 64}, {64, 0, 0});
  addAs(0, {40, 9, 0}, {0, 0, 64}, {20, 0, 0});
  addAs(1, {40, 10, 0}, {0, 0, 64}, {20, 0, 0});
  placement::PlacementReport report;
  const geometry::PlacedSector placed = place(s, {0, 0}, {}, &report);
  CHECK(report.under_water == 8 * 16 + 5 * 16);  // of 16 x 16 lines: the lake's half, and the top of the roof
  CHECK(report.uncovered.empty());
  REQUIRE(countBetween(placed, 0.9, 1.1) >= 24);
  for (const geometry::Probe& p : placed.probe)
    CHECK((p.position.x > 32.0 || p.position.y > 2.0));  // probes above the leaves' box
}

TEST_CASE("Placement, NothingInsideBodies") {
  geometry::Surfaces s = groundOf({0.5, 0.5, 0.5});
  addBoxOutside(s, {8, -1, 8}, {40, 5, 40}, 0);
  placement::PlacementReport report;
  const geometry::PlacedSector sector = place(s, {0, 0}, {}, &report);
  CHECK(report.buried == 64);
  for (const geometry::Probe& p : sector.probe) {
    const bool inside =
        p.position.x > 8 && p.position.x < 40 && p.position.z > 8 && p.position.z < 40 && p.position.y < 5;
    CHECK_FALSE(inside);
  }
  CHECK(countBetween(sector, 5.9, 6.1) == 16);
  CHECK(report.dropped.empty());
}

TEST_CASE("Placement, AProbeTooCloseToAWallIsMovedAndReported") {
  geometry::Surfaces s = groundOf({0.5, 0.5, 0.5});
  addBoxOutside(s, {2.4, 0, 0}, {3, 4, 64},
                0);  // the first lines of the lattice are at 2.287
  placement::PlacementReport report;
  const geometry::PlacedSector sector = place(s, {0, 0}, {}, &report);
  CHECK(report.moved.size() == 16);
  const geometry::Tracer tracer(s);
  for (const geometry::Probe& p : sector.probe)
    CHECK(placement::placeAt(tracer, p.position, 0.2) == placement::Place::free);
  for (const placement::MovedProbe& m : report.moved) CHECK(m.to.x < 2.21);
  CHECK(report.uncovered.empty());
}

TEST_CASE("Placement, EveryWalkablePointSeesAProbe") {
  geometry::Surfaces s = groundOf({0.5, 0.5, 0.5});
  const double wall = 4.0;
  for (int i = 0; i <= 16; ++i)  // closets of 4 m, without doors
    for (int axis = 0; axis < 2; ++axis)
      addBoxOutside(s, axis == 0 ? Number3(wall * i - 0.05, -1, 0) : Number3(0, -1, wall * i - 0.05),
                    axis == 0 ? Number3(wall * i + 0.05, 4, 64) : Number3(64, 4, wall * i + 0.05), 0);
  placement::PlacementReport report;
  const geometry::PlacedSector sector = place(s, {0, 0}, {}, &report);
  CHECK(sector.probe.size() == 255);
  CHECK(std::count_if(report.dropped.begin(), report.dropped.end(), [](const placement::DroppedProbe& d) {
          return d.reason == placement::DroppedProbe::Reason::thinned;
        }) == 1);
  CHECK(report.uncovered.size() == 5);  // one on the lattice, four between its lines
}

TEST_CASE("Placement, AClosetBetweenTheLinesGetsAProbe") {
  geometry::Surfaces s = groundOf({0.5, 0.5, 0.5});
  addBoxOutside(s, {3, -1, 3}, {5.6, 3, 5.6},
                0);  // the lines are at 2.287 and 6.287
  addBoxInside(s, {3.1, 0.1, 3.1}, {5.5, 2.9, 5.5}, 0);
  placement::PlacementReport report;
  const geometry::PlacedSector sector = place(s, {0, 0}, {}, &report);
  CHECK(report.added_for_sight >= 1);
  CHECK(report.uncovered.empty());
  CHECK(std::count_if(sector.probe.begin(), sector.probe.end(), [](const geometry::Probe& p) {
          return geometry::contains({{3.1, 0.1, 3.1}, {5.5, 2.9, 5.5}}, p.position);
        }) == 1);
}

TEST_CASE("Placement, InASoupItGivesUpTheSameForAnyThreads") {
  const geometry::Surfaces s = soupOf(150);
  const auto placed = [&](int threads, placement::PlacementReport& report) {
    tbb::task_arena arena(threads);
    return arena.execute([&] { return place(s, {0, 0}, {}, &report); });
  };
  placement::PlacementReport one, three;
  const geometry::PlacedSector first = placed(1, one);
  const geometry::PlacedSector second = placed(3, three);
  CHECK(one.dropped.size() > 200);  // far more than are searched for
  CHECK(one.dropped.size() == three.dropped.size());
  REQUIRE(first.probe.size() == second.probe.size());
  CHECK(!first.probe.empty());
  for (std::size_t i = 0; i < first.probe.size(); ++i) CHECK(first.probe[i].position == second.probe[i].position);
  CHECK((first.grid == second.grid));
}

TEST_CASE("Placement, SearchesTakeABoundedNumberOfRays") {
  const auto raysLeft = [](const geometry::Surfaces& s) {
    const geometry::Tracer tracer(s);
    placement::PlacementReport report;
    return placement::candidatesOf(tracer, {0, 0}, {}, placement::topOver(s, {0, 0}).value(), report).search_rays;
  };
  CHECK(raysLeft(groundOf({0.5, 0.5, 0.5})) == placement::kMostSearchRays);
  CHECK(raysLeft(soupOf(150)) == 0);
  geometry::Surfaces sheets = groundOf({0.5, 0.5, 0.5});  // 64 spans on every line: half of the rays
  const auto two_sides = addMaterial(sheets, Number3(0.5), true);
  for (int i = 1; i < 64; ++i) addQuad(sheets, {-10, 0.05 * i, -10}, {0, 0, 100}, {100, 0, 0}, two_sides);
  CHECK(raysLeft(sheets) == placement::kMostSearchRays / 2);
}

}  // namespace welkin::tests
