// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/grid.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "probes/occlusion_tile.h"
#include "probes/placement/grid_cells.h"
#include "probes/placement/placement.h"
#include "probes/placement/validity.h"
#include "rooms.h"

namespace welkin::probes {
namespace {

Number3 middleOf(const PlacedSector& s, int i, int j, int k) {
  return {kSector_m * s.id.x + (i + 0.5) * kCell_m + kAside_x_m, s.low_y + (j + 0.5) * s.cell_height_m,
          kSector_m * s.id.z + (k + 0.5) * kCell_m + kAside_z_m};
}

template <typename Visit>
void forCells(Visit visit) {
  for (int k = 0; k < kCells; ++k)
    for (int j = 0; j < kCells; ++j)
      for (int i = 0; i < kCells; ++i) visit(i, j, k);
}

PlacedSector place(const Tracer& tracer, const SectorId& id, PlacementReport& report,
                   const PlacementSettings& settings = {}) {
  return placeSector(tracer, id, settings, report);
}

}  // namespace

TEST_CASE("Grid, NearestProbeOfOpenGround") {
  const Surfaces s = tests::groundOf({0.5, 0.5, 0.5});
  const Tracer tracer(s);
  PlacementReport report;
  const PlacedSector sector = place(tracer, {-1, 2}, report);
  CHECK(report.cells_by_middle == kAllCells);
  forCells([&](int i, int j, int k) {
    const Number3 middle = middleOf(sector, i, j, k);
    double nearest = 1e9;
    for (const Probe& p : sector.probe) nearest = std::min(nearest, distanceOf(middle, p.position));
    constexpr double kEqual_m = 1e-6;  // what counts as equally near
    CHECK(distanceOf(middle, sector.probe[sector.grid[cellIndex(i, j, k)]].position) <= nearest + kEqual_m);
  });
  for (int k = 0; k < kCells; ++k)
    for (int i = 0; i < kCells; ++i)
      CHECK(sector.top[static_cast<std::size_t>(i + kCells * k)] == sector.grid[cellIndex(i, 0, k)]);
}

TEST_CASE("Grid, AThinWallIsNeverCrossed") {
  for (const double wall : {17.0, 18.0, 20.0, 21.3}) {
    Surfaces s;
    const auto stone = tests::addMaterial(s, {0.5, 0.5, 0.5});
    tests::addBoxInside(s, {1, 0, 1}, {wall - 0.05, 3.6, 31}, stone);
    tests::addBoxInside(s, {wall + 0.05, 0, 1}, {50, 3.6, 31}, stone);
    const Tracer tracer(s);
    PlacementReport report;
    const PlacedSector sector = place(tracer, {0, 0}, report);
    std::size_t west = 0;
    std::size_t named = 0;
    for (const Probe& p : sector.probe) west += p.position.x < wall ? 1 : 0;
    CHECK(west > 2);
    CHECK(sector.probe.size() - west > 2);
    forCells([&](int i, int j, int k) {
      const std::uint8_t probe = sector.grid[cellIndex(i, j, k)];
      if (probe == kNoProbe) return;
      ++named;
      const double x = 4.0 * i + 2.0 + kAside_x_m;
      if (x < wall - 0.05 - 2.0) CHECK(sector.probe[probe].position.x < wall);
      CAPTURE(wall, i, j, k);
      if (x > wall + 0.05 + 2.0) CHECK(sector.probe[probe].position.x > wall);
      if (j == 0 && x < wall - 0.05) CHECK(sector.probe[probe].position.x < wall);
      if (j == 0 && x > wall + 0.05) CHECK(sector.probe[probe].position.x > wall);
    });
    CHECK(named >= 13 * 7);
    CHECK(report.uncovered.empty());
    CHECK(report.ground_cells_without == 0);
  }
}

TEST_CASE("Grid, GroundAboveTheMiddleOfACellIsServed") {
  Surfaces s;  // ground at 3.9: the middles of its cells are below it
  tests::addQuad(s, {-100, 3.9, -100}, {0, 0, 200}, {200, 0, 0}, tests::addMaterial(s, {0.5, 0.5, 0.5}));
  const Tracer tracer(s);
  PlacementReport report;
  const PlacedSector sector = place(tracer, {0, 0}, report);
  CHECK(sector.low_y == 0.0);
  CHECK(report.cells_by_part == 256);
  CHECK(report.cells_without == 0);
}

TEST_CASE("Grid, CellsUnderATerrainTakeWhatAllAboutThemSee") {
  Surfaces s;  // a step of 14 m: three layers of cells in the ground, of which filtering reaches one
  const auto stone = tests::addMaterial(s, {0.5, 0.5, 0.5});
  tests::addQuad(s, {-100, 0, -100}, {0, 0, 200}, {132, 0, 0}, stone);
  tests::addQuad(s, {32, 0, -100}, {0, 0, 200}, {0, 14, 0}, stone);  // looks west
  tests::addQuad(s, {32, 14, -100}, {0, 0, 200}, {100, 0, 0}, stone);
  const Tracer tracer(s);
  PlacementReport report;
  const PlacedSector sector = place(tracer, {0, 0}, report);
  forCells([&](int i, int j, int k) {
    const std::uint8_t probe = sector.grid[cellIndex(i, j, k)];
    if (i >= 10 && j == 2) {
      REQUIRE(probe != kNoProbe);
      CHECK(sector.probe[probe].position.y == 15.0);
    }
    if (i >= 10 && j < 2) CHECK(probe == kNoProbe);
    if (i == 8 && j == 0 && probe != kNoProbe) CHECK(sector.probe[probe].position.y == 1.0);
  });
  CHECK(report.ground_cells_without == 0);
}

TEST_CASE("Grid, AThickWallBetweenTwoRoomsIsNotFilteredThrough") {
  Surfaces s;
  const auto stone = tests::addMaterial(s, {0.5, 0.5, 0.5});
  tests::addBoxInside(s, {1, 0, 1}, {16, 7, 31}, stone);
  tests::addBoxInside(s, {20, 0, 1}, {50, 7, 31}, stone);  // cells 4 are all wall
  const Tracer tracer(s);
  PlacementReport report;
  const PlacedSector sector = place(tracer, {0, 0}, report);
  for (int k = 1; k < 7; ++k) {
    CHECK(sector.grid[cellIndex(4, 0, k)] == kNoProbe);
    CHECK(sector.grid[cellIndex(3, 0, k)] != kNoProbe);
    CHECK(sector.grid[cellIndex(5, 0, k)] != kNoProbe);
  }
}

TEST_CASE("Grid, RoundACorner") {
  Surfaces s = tests::groundOf({0.5, 0.5, 0.5});
  tests::addBoxOutside(s, {20, 0, 0}, {20.2, 60, 44}, 0);  // a screen with no probe behind it
  PlacementSettings settings;
  settings.remove = {{{20.2, -1, -1}, {65, 90, 65}}};
  const Tracer tracer(s);
  PlacementReport report;
  const PlacedSector sector = place(tracer, {0, 0}, report, settings);
  CHECK(report.cells_by_way > 50);
  CHECK(report.ground_cells_without == 0);
  CHECK(sector.grid[cellIndex(6, 0, 2)] != kNoProbe);
}

TEST_CASE("Grid, ASealedRoomWithoutAProbeHasNone") {
  Surfaces s = tests::groundOf({0.5, 0.5, 0.5});
  tests::addBoxOutside(s, {20, -1, 20}, {44, 12, 44}, 0);
  tests::addBoxInside(s, {20.2, 0.2, 20.2}, {43.8, 11.8, 43.8}, 0);
  PlacementSettings settings;
  settings.remove = {{{20, -1, 20}, {44, 12, 44}}};
  const Tracer tracer(s);
  PlacementReport report;
  const PlacedSector sector = place(tracer, {0, 0}, report, settings);
  for (int k = 6; k < 10; ++k)
    for (int i = 6; i < 10; ++i) CHECK(sector.grid[cellIndex(i, 0, k)] == kNoProbe);
  CHECK(report.ground_cells_without >= 16);
}

TEST_CASE("Grid, TallAndDeepSectors") {
  Surfaces s;
  const auto stone = tests::addMaterial(s, {0.5, 0.5, 0.5});
  tests::addQuad(s, {-100, -37, -100}, {0, 0, 200}, {200, 0, 0}, stone);
  tests::addBoxOutside(s, {16, 61, 16}, {48, 62, 48}, stone);
  const Tracer tracer(s);
  PlacementReport report;
  const PlacedSector sector = place(tracer, {0, 0}, report);
  CHECK(sector.low_y == -40.0);
  CHECK(sector.cell_height_m == 8.0);
  for (const Probe& p : sector.probe) {
    CHECK(p.position.y >= sector.low_y);
    CHECK(p.position.y < sector.low_y + kCells * sector.cell_height_m);
  }
  CHECK(report.ground_cells_without == 0);
  const std::uint8_t above = sector.top[8 + kCells * 8];
  REQUIRE(above != kNoProbe);
  CHECK(sector.probe[above].position.y == Approx(63.0));
}

TEST_CASE("Grid, FromAboveEveryCellNamesAProbe") {
  Surfaces s;
  tests::addQuad(s, {0, 0, 0}, {0, 0, 64}, {17, 0, 0}, tests::addMaterial(s, {0.5, 0.5, 0.5}));
  const Tracer tracer(s);
  PlacementReport report;
  const PlacedSector sector = place(tracer, {0, 0}, report);
  for (int k = 0; k < kCells; ++k) {
    // The fifth column of cells has its middle beside the ground, the fourth above it.
    const std::uint8_t last = sector.top[static_cast<std::size_t>(3 + kCells * k)];
    CHECK(last < sector.probe.size());
    for (int i = 4; i < kCells; ++i) CHECK(sector.top[static_cast<std::size_t>(i + kCells * k)] == last);
  }
  CHECK(sector.top[3] != sector.top[3 + kCells * 15]);
}

TEST_CASE("OcclusionTile, VisibilityAndHeightFromAbove") {
  SectorProbes probes;
  std::array<std::uint8_t, kCells * kCells> top{};
  CHECK_FALSE(occlusionTileOf(top, probes));
  probes.position = {{1, 5, 1}, {60, 9, 60}};
  probes.transfer.resize(2);
  probes.transfer[0].visibility = {0.25, 0.25, 0.25, 0.0};
  probes.transfer[1].visibility = {1.0, 0.5, 0.0, 0.0};  // the three are alike from above
  top[15 + kCells * 14] = 1;
  const auto tile = occlusionTileOf(top, probes);
  REQUIRE(tile);
  CHECK(tile->sky_visibility[0] == Approx(0.25));
  CHECK(tile->probe_y[0] == 5.0);
  CHECK(tile->sky_visibility[15 + kCells * 14] == Approx(0.5));
  CHECK(tile->probe_y[15 + kCells * 14] == 9.0);
  CHECK(tile->sky_visibility[14 + kCells * 15] == Approx(0.25));
}

}  // namespace welkin::probes
