// SPDX-License-Identifier: Apache-2.0
// Placement by hand, over vegetation and in rooms; the list of sectors; independence of threads.
#include <tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <limits>

#include "placed.h"
#include "probes/placement/placement.h"
#include "probes/placement/validity.h"
#include "sky/base/error.h"

namespace welkin::tests {

using f64::Number3;
namespace {

bool same(const geometry::PlacedSector& a, const geometry::PlacedSector& b) {
  return a.id == b.id && a.low_y == b.low_y && a.cell_height_m == b.cell_height_m && a.grid == b.grid &&
         a.top == b.top && a.in_room == b.in_room &&
         std::equal(a.probe.begin(), a.probe.end(), b.probe.begin(), b.probe.end(),
                    [](const geometry::Probe& p, const geometry::Probe& q) { return p.position == q.position; });
}

/// Level ground with houses, steps and a hanging slab about the corner of four sectors.
geometry::Surfaces village() {
  geometry::Surfaces s = groundOf({0.5, 0.5, 0.5}, 90.0);
  for (int i = -3; i < 4; ++i)
    for (int k = -3; k < 4; ++k)
      addBoxOutside(s, {19.3 * i - 4, 0, 17.7 * k - 3}, {19.3 * i + 3, 3.0 + i + 0.5 * k, 17.7 * k + 2.5}, 0);
  addBoxOutside(s, {-9, 6.5, -9}, {9, 7, 9}, 0);
  return s;
}

}  // namespace

TEST_CASE("Placement, ByHand") {
  const geometry::Surfaces s = groundOf({0.5, 0.5, 0.5});
  placement::PlacementSettings settings;
  settings.add = {{10, 1, 10}, {10.5, 1, 10}, {20, -0.5, 20}, {30, -8, 30}, {100, 1, 10}, {30, 1, 30}};
  settings.remove = {{{24, 0, 24}, {64, 4, 64}}};
  placement::PlacementReport report;
  const geometry::PlacedSector sector = place(s, {0, 0}, settings, &report);
  REQUIRE(sector.probe.size() > 4);
  CHECK(sector.probe[0].position == Number3(10, 1, 10));
  CHECK(sector.probe[1].position == Number3(10.5, 1, 10));  // kept although near another, as it is by hand
  CHECK(sector.probe[3].position == Number3(30, 1, 30));    // kept in a box of `remove`, as it is by hand
  REQUIRE(report.moved.size() == 1);
  CHECK(report.moved[0].by_hand);
  CHECK(report.moved[0].from == Number3(20, -0.5, 20));
  CHECK(report.moved[0].to == sector.probe[2].position);
  CHECK(report.moved[0].to.y > 0.19);
  REQUIRE(report.dropped.size() == 1);
  CHECK(report.dropped[0].by_hand);
  CHECK(report.dropped[0].position == Number3(30, -8, 30));
  CHECK(report.dropped[0].reason == placement::DroppedProbe::Reason::inside);
  CHECK(report.removed == 100);
  for (std::size_t i = 4; i < sector.probe.size(); ++i) {
    CHECK_FALSE(geometry::contains(settings.remove[0], sector.probe[i].position));
    CHECK(placement::distanceOf(sector.probe[i].position, {10, 1, 10}) >= 7.0);
  }
  CHECK(place(s, {1, 0}, settings).probe[0].position == Number3(100, 1, 10));
}

TEST_CASE("Placement, ThoseByHandOutliveThinning") {
  const geometry::Surfaces s = groundOf({0.5, 0.5, 0.5});
  placement::PlacementSettings settings;
  settings.minimum_separation_m = 0.0;
  for (int i = 0; i < 20; ++i) settings.add.push_back({1.0 + 3 * i, 1.5, 33});
  placement::PlacementReport report;
  const geometry::PlacedSector sector = place(s, {0, 0}, settings, &report);
  CHECK(sector.probe.size() == geometry::kMostProbes);
  CHECK(report.dropped.size() == 256 + 20 - geometry::kMostProbes);
  for (const placement::DroppedProbe& d : report.dropped) CHECK_FALSE(d.by_hand);
  for (std::size_t i = 0; i < 20; ++i) CHECK(sector.probe[i].position == settings.add[i]);
}

TEST_CASE("Placement, AboveTheBoxesOfVegetation") {
  geometry::Surfaces s = groundOf({0.5, 0.5, 0.5});
  const auto leaf = addMaterial(s, {0.1, 0.4, 0.1}, true);
  const auto tree = [&](const Number3& low, const Number3& high) {
    s.object.push_back({"tree", geometry::Role::vegetation});
    const std::size_t first = s.triangle.size();
    addQuad(s, low, {high.x - low.x, 0, 0}, {0, 0.5 * (high.y - low.y), 0}, leaf);
    addQuad(s, {low.x, high.y, low.z}, {high.x - low.x, 0, 0}, {0, 0, high.z - low.z}, leaf);
    for (std::size_t i = first; i < s.triangle.size(); ++i)
      s.triangle[i].object = static_cast<std::uint32_t>(s.object.size() - 1);
  };
  tree({0, 0, 0}, {16, 20, 16});    // lines at 4 and 12
  tree({10, 0, 10}, {14, 30, 14});  // higher, at (12, 12)
  tree({33, 0, 33}, {35, 12, 35});  // no line meets it
  tree({65, 0, 0}, {90, 50, 60});   // the next sector's
  const geometry::PlacedSector sector = place(s, {0, 0});
  CHECK(countBetween(sector, 0, 1.5) == 64);  // leaves are no ground and stop no ray
  CHECK(countBetween(sector, 20.9, 21.1) == 3);
  CHECK(countBetween(sector, 30.9, 31.1) == 1);
  CHECK(countBetween(sector, 12.9, 13.1) == 1);
  CHECK(sector.probe.size() == 69);
}

TEST_CASE("Placement, SectorsOfALevel") {
  geometry::Surfaces s;
  const auto stone = addMaterial(s, {0.5, 0.5, 0.5});
  addQuad(s, {-70, 0, 10}, {0, 0, 20}, {80, 0, 0}, stone);     // three sectors along x
  addQuad(s, {200, 0, 200}, {0, 0, .09}, {.09, 0, 0}, stone);  // too small to stand on
  addQuad(s, {300, 0, 300}, {20, 0, 0}, {0, 0, 20}, stone);    // looks down
  addQuad(s, {400, 0, 0}, {0, 9, 0}, {0, 0, 20}, stone);       // a wall
  placement::PlacementSettings settings;
  CHECK(placement::sectorsOf(s, settings) == std::vector<geometry::SectorId>{{-2, 0}, {-1, 0}, {0, 0}});
  settings.add = {{-1, 5, -1000}};
  CHECK(placement::sectorsOf(s, settings) == std::vector<geometry::SectorId>{{-2, 0}, {-1, -16}, {-1, 0}, {0, 0}});
  s.object.push_back({"tree", geometry::Role::vegetation});
  addQuad(s, {500, 0, 0}, {1, 0, 0}, {0, 9, 1}, stone);
  for (std::size_t i = s.triangle.size() - 2; i < s.triangle.size(); ++i) s.triangle[i].object = 1;
  CHECK(placement::sectorsOf(s, settings).back() == geometry::SectorId{7, 0});
  CHECK(placement::sectorsOf({}, {}).empty());
  settings.within = {{{-70, 0, 0}, {-65, 1, 1}}, {{5, -9, 5}, {6, -8, 6}}};  // any height
  CHECK(placement::sectorsOf(s, settings) == std::vector<geometry::SectorId>{{-2, 0}, {-1, -16}, {0, 0}});
  settings.within = {{{450, 0, 0}, {460, 1, 1}}};  // the tree's sector
  CHECK(placement::sectorsOf(s, settings) == std::vector<geometry::SectorId>{{-1, -16}, {7, 0}});
  settings.within = {{{900, 0, 0}, {960, 1, 1}}};
  settings.add.clear();
  CHECK(placement::sectorsOf(s, settings).empty());
}

TEST_CASE("Placement, GroundBetweenTheLinesHasASectorAndProbes") {
  const auto stone = [](geometry::Surfaces& s) { return addMaterial(s, {0.5, 0.5, 0.5}); };
  SECTION("a strip that only the lattice of half the spacing meets") {
    geometry::Surfaces s = groundOf({0.5, 0.5, 0.5}, 65.9);
    CHECK(placement::sectorsOf(s, {}).size() == 16);
    CHECK(place(s, {1, 0}).probe.size() >= 8);
  }
  SECTION("a board that no line meets, in triangles of which none is large enough") {
    geometry::Surfaces s;
    const auto material = stone(s);
    for (int i = 0; i < 200; ++i) addQuad(s, {71.5, 2, 10 + 0.05 * i}, {0, 0, 0.05}, {0.1, 0, 0}, material);
    REQUIRE(placement::sectorsOf(s, {}) == std::vector<geometry::SectorId>{{1, 0}});
    placement::PlacementReport report;
    const geometry::PlacedSector sector = place(s, {1, 0}, {}, &report);
    REQUIRE((sector.probe.size() == 1 || sector.probe.size() == 2));  // 7 m apart on 10 m
    for (const geometry::Probe& p : sector.probe)
      CHECK((p.position.x > 71.5 && p.position.x < 71.6 && p.position.y == 3.0));
    CHECK(report.uncovered.empty());
    CHECK(report.walkable > 0);
  }
  SECTION("a floor across a border, and a roof too steep") {
    geometry::Surfaces s;
    const auto material = stone(s);
    addQuad(s, {60, 0, 70}, {0, 0, 0.3}, {4.2, 0, 0}, material);
    addQuad(s, {128, 0, 71.4}, {0, 0, 0.4}, {0.2, 0.5, 0}, material);
    CHECK(placement::sectorsOf(s, {}) == std::vector<geometry::SectorId>{{0, 1}, {1, 1}});
    const geometry::PlacedSector sector = place(s, {1, 1});
    REQUIRE(sector.probe.size() == 1);
    CHECK(sector.probe[0].position.x == Approx(64.1).margin(0.05));  // of two triangles
    CHECK(place(s, {2, 1}).probe.empty());
  }
}

TEST_CASE("Placement, LevelsTooWideAreRefused") {
  geometry::Surfaces s = groundOf({0.5, 0.5, 0.5}, 33e3);
  s.object[0].name = "sea floor";
  CHECK_THROWS_WITH(placement::sectorsOf(s, {}), Catch::Contains("\"sea floor\" spans 1065024 sectors"));
  placement::PlacementSettings harbour;
  harbour.within = {{{-10, 0, 70}, {10, 1, 80}}};
  CHECK(placement::sectorsOf(s, harbour) == std::vector<geometry::SectorId>{{-1, 1}, {0, 1}});
  geometry::Surfaces forest = groundOf({0.5, 0.5, 0.5}, 60.0);
  forest.object.push_back({"forest", geometry::Role::vegetation});
  for (const double at : {-40e3, 40e3}) {
    addQuad(forest, {at, 0, at}, {0, 0, 1}, {1, 0, 0}, 0);
    for (std::size_t i = forest.triangle.size() - 2; i < forest.triangle.size(); ++i) forest.triangle[i].object = 1;
  }
  CHECK_THROWS_WITH(placement::sectorsOf(forest, {}),
                    Catch::Contains("vegetation from (-40000, -40000) to (40001, 40001) m"));
}

TEST_CASE("Placement, ACheckpointEndsIt") {
  const geometry::Surfaces s = village();
  const geometry::Tracer tracer(s);
  placement::PlacementSettings settings;
  settings.spacing_m = 1.0;
  settings.minimum_separation_m = 0.5;  // thins
  placement::PlacementReport report;
  const auto kEnough = Catch::Contains("interrupted");
  std::atomic<int> calls = 0;
  int last = std::numeric_limits<int>::max();
  const base::Progress checkpoint([&](const base::Progress::Stage&, base::Progress::Event) { return ++calls <= last; });
  calls = 0;
  placement::placeSector(tracer, {0, 0}, settings, report, checkpoint);
  const int all = calls;
  CHECK(all > 10000);
  for (const double share : {0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99}) {
    calls = 0;
    last = static_cast<int>(share * all);
    CHECK_THROWS_WITH(placement::placeSector(tracer, {0, 0}, settings, report, checkpoint), kEnough);
    CHECK(calls <= last + 64);  // a thread or two may have begun
  }
  calls = 0;
  last = 2;
  CHECK_THROWS_WITH(placement::placeProbes(tracer, {0, 0}, settings, checkpoint), kEnough);
  calls = 0;
  CHECK_THROWS_WITH(placement::sectorsOf(s, settings, checkpoint), kEnough);
}

TEST_CASE("Placement, SectorsAreThoseThatGetProbes") {
  const geometry::Surfaces s = village();
  const auto sectors = placement::sectorsOf(s, {});
  CHECK(sectors.size() == 16);
  for (int x = -3; x < 3; ++x)
    for (int z = -3; z < 3; ++z) {
      const bool named = std::find(sectors.begin(), sectors.end(), geometry::SectorId{x, z}) != sectors.end();
      CHECK(place(s, {x, z}).probe.empty() == !named);
    }
}

TEST_CASE("Placement, SameBytesForAnyThreadsAndForASectorAlone") {
  const geometry::Surfaces all = village();
  geometry::Surfaces near = all;  // only the surfaces near the sector, in another order
  std::erase_if(near.triangle, [&](const geometry::Triangle& t) {
    double high = -1e9;
    for (const auto v : t.vertex) high = std::max(high, double{near.position[v][0]});
    return high < -64.0;
  });
  std::reverse(near.triangle.begin(), near.triangle.end());
  for (const geometry::SectorId id : {geometry::SectorId{0, 0}, geometry::SectorId{0, -1}}) {
    geometry::PlacedSector one;
    geometry::PlacedSector four;
    {
      const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 1);
      one = place(all, id);
    }
    {
      const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 4);
      four = place(all, id);
    }
    CHECK(one.probe.size() > 40);
    CHECK(same(one, four));
    CHECK(same(one, place(near, id)));
  }
}

TEST_CASE("Placement, RoomsHaveProbesOfTheirOwn") {
  const geometry::Surfaces s = groundOf({0.5, 0.5, 0.5});
  placement::PlacementSettings settings;
  settings.room = {{{0, -1, 0}, {9, 4, 9}}};
  const geometry::PlacedSector sector = place(s, {0, 0}, settings);
  for (int k = 0; k < geometry::kCells; ++k)
    for (int j = 0; j < geometry::kCells; ++j)
      for (int i = 0; i < geometry::kCells; ++i) {
        const std::uint8_t probe =
            sector.grid[static_cast<std::size_t>(i + geometry::kCells * (j + geometry::kCells * k))];
        const Number3 middle{4 * i + 2.037, 4 * j + 2.0, 4 * k + 2.021};
        REQUIRE(probe != geometry::kNoProbe);
        CHECK(placement::roomOf(settings, sector.probe[probe].position) == placement::roomOf(settings, middle));
      }
}

TEST_CASE("Placement, RoomsNameTheirProbes") {
  const geometry::Surfaces s = groundOf({0.5, 0.5, 0.5});
  placement::PlacementSettings settings;
  settings.room = {{{200, -1, 200}, {210, 4, 210}},  // in another sector
                   {{-30, -1, 8}, {20, 4, 40}},      // in two sectors
                   {{10, -1, 8}, {30, 4, 40}},       // partly in the first one
                   {{50, 20, 50}, {60, 30, 60}}};    // in the air
  for (const geometry::SectorId id : {geometry::SectorId{0, 0}, geometry::SectorId{-1, 0}}) {
    const geometry::PlacedSector sector = place(s, id, settings);
    CAPTURE(id.x);
    REQUIRE(sector.room.size() == (id.x == 0 ? 3 : 1));
    REQUIRE(sector.in_room.size() == sector.probe.size());
    for (std::size_t i = 0; i < sector.probe.size(); ++i) {
      const std::size_t of_level = placement::roomOf(settings, sector.probe[i].position);
      CHECK(std::size_t{sector.in_room[i]} == (of_level == 0 ? 0 : of_level - 1));
    }
    for (std::size_t r = 0; r < sector.room.size(); ++r) CHECK(sector.room[r].box == settings.room[r + 1]);
    // The room's probe that is nearest to the middle of its part of the sector.
    const Number3 middle = id.x == 0 ? Number3(10, 1.5, 24) : Number3(-15, 1.5, 24);
    REQUIRE(sector.room[0].probe != geometry::kNoProbe);
    for (std::size_t i = 0; i < sector.probe.size(); ++i)
      if (sector.in_room[i] == 1)
        CHECK(placement::distanceOf(sector.probe[i].position, middle) >=
              placement::distanceOf(sector.probe[sector.room[0].probe].position, middle));
  }
  const geometry::PlacedSector sector = place(s, {0, 0}, settings);
  CHECK(placement::roomOf(settings, sector.probe[sector.room[1].probe].position) == 3);
  CHECK(sector.room[2].probe == geometry::kNoProbe);
  CHECK((place(s, {1, 1}, settings).room.empty() && place(s, {1, 1}, settings).in_room.empty()));
  settings.room.assign(geometry::kMostRooms + 1, {{0, -1, 0}, {9, 4, 9}});
  CHECK_THROWS_WITH(place(s, {0, 0}, settings), Catch::Contains("[[room]]: more than 254 touch sector 0_0"));
  CHECK(place(s, {1, 0}, settings).room.empty());
}

TEST_CASE("Placement, SettingsOutOfRangeAreErrors") {
  const geometry::Surfaces s = groundOf({0.5, 0.5, 0.5});
  placement::PlacementSettings settings;
  settings.spacing_m = 0.0;
  CHECK_THROWS_WITH(placement::sectorsOf(s, settings), Catch::Contains("spacing_m = 0"));
  settings = {};
  settings.remove = {{{0, 0, 0}, {1, -1, 1}}};
  CHECK_THROWS_WITH(place(s, {0, 0}, settings), Catch::Contains("remove"));
}

}  // namespace welkin::tests
