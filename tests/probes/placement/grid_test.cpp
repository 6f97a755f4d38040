// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/grid.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "probes/placement/grid_cells.h"
#include "probes/placement/placement.h"
#include "probes/placement/validity.h"
#include "probes/sectors/occlusion_tile.h"
#include "tests/probes/rooms.h"

namespace welkin::tests {

using f64::Number3;
namespace {

Number3 middleOf(const geometry::PlacedSector& s, int i, int j, int k) {
  return {geometry::kSector_m * s.id.x + (i + 0.5) * geometry::kCell_m + placement::kAside_x_m,
          s.low_y + (j + 0.5) * s.cell_height_m,
          geometry::kSector_m * s.id.z + (k + 0.5) * geometry::kCell_m + placement::kAside_z_m};
}

template <typename Visit>
void forCells(Visit visit) {
  for (int k = 0; k < geometry::kCells; ++k)
    for (int j = 0; j < geometry::kCells; ++j)
      for (int i = 0; i < geometry::kCells; ++i) visit(i, j, k);
}

geometry::PlacedSector place(const geometry::Tracer& tracer, const geometry::SectorId& id,
                             placement::PlacementReport& report, const placement::PlacementSettings& settings = {}) {
  return placement::placeSector(tracer, id, settings, report);
}

}  // namespace

TEST_CASE("Grid, NearestProbeOfOpenGround") {
  const geometry::Surfaces s = groundOf({0.5, 0.5, 0.5});
  const geometry::Tracer tracer(s);
  placement::PlacementReport report;
  const geometry::PlacedSector sector = place(tracer, {-1, 2}, report);
  CHECK(report.cells_by_middle == placement::kAllCells);
  forCells([&](int i, int j, int k) {
    const Number3 middle = middleOf(sector, i, j, k);
    double nearest = 1e9;
    for (const geometry::Probe& p : sector.probe)
      nearest = std::min(nearest, placement::distanceOf(middle, p.position));
    constexpr double kEqual_m = 1e-6;  // differences below this count as equal
    CHECK(placement::distanceOf(middle, sector.probe[sector.grid[placement::cellIndex(i, j, k)]].position) <=
          nearest + kEqual_m);
  });
  for (int k = 0; k < geometry::kCells; ++k)
    for (int i = 0; i < geometry::kCells; ++i)
      CHECK(sector.top[static_cast<std::size_t>(i + geometry::kCells * k)] ==
            sector.grid[placement::cellIndex(i, 0, k)]);
}

TEST_CASE("Grid, AThinWallIsNeverCrossed") {
  for (const double wall : {17.0, 18.0, 20.0, 21.3}) {
    geometry::Surfaces s;
    const auto stone = addMaterial(s, {0.5, 0.5, 0.5});
    addBoxInside(s, {1, 0, 1}, {wall - 0.05, 3.6, 31}, stone);
    addBoxInside(s, {wall + 0.05, 0, 1}, {50, 3.6, 31}, stone);
    const geometry::Tracer tracer(s);
    placement::PlacementReport report;
    const geometry::PlacedSector sector = place(tracer, {0, 0}, report);
    std::size_t west = 0;
    std::size_t named = 0;
    for (const geometry::Probe& p : sector.probe) west += p.position.x < wall ? 1 : 0;
    CHECK(west > 2);
    CHECK(sector.probe.size() - west > 2);
    forCells([&](int i, int j, int k) {
      const std::uint8_t probe = sector.grid[placement::cellIndex(i, j, k)];
      if (probe == geometry::kNoProbe) return;
      ++named;
      const double x = 4.0 * i + 2.0 + placement::kAside_x_m;
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
  geometry::Surfaces s;  // ground at 3.9; the middles of its cells are below it
  addQuad(s, {-100, 3.9, -100}, {0, 0, 200}, {200, 0, 0}, addMaterial(s, {0.5, 0.5, 0.5}));
  const geometry::Tracer tracer(s);
  placement::PlacementReport report;
  const geometry::PlacedSector sector = place(tracer, {0, 0}, report);
  CHECK(sector.low_y == 0.0);
  CHECK(report.cells_by_part == 256);
  CHECK(report.cells_without == 0);
}

TEST_CASE("Grid, CellsUnderATerrainTakeWhatAllAboutThemSee") {
  geometry::Surfaces s;  // a step of 14 m; filtering reaches one of three cell layers in the ground
  const auto stone = addMaterial(s, {0.5, 0.5, 0.5});
  addQuad(s, {-100, 0, -100}, {0, 0, 200}, {132, 0, 0}, stone);
  addQuad(s, {32, 0, -100}, {0, 0, 200}, {0, 14, 0}, stone);  // looks west
  addQuad(s, {32, 14, -100}, {0, 0, 200}, {100, 0, 0}, stone);
  const geometry::Tracer tracer(s);
  placement::PlacementReport report;
  const geometry::PlacedSector sector = place(tracer, {0, 0}, report);
  forCells([&](int i, int j, int k) {
    const std::uint8_t probe = sector.grid[placement::cellIndex(i, j, k)];
    if (i >= 10 && j == 2) {
      REQUIRE(probe != geometry::kNoProbe);
      CHECK(sector.probe[probe].position.y == 15.0);
    }
    if (i >= 10 && j < 2) CHECK(probe == geometry::kNoProbe);
    if (i == 8 && j == 0 && probe != geometry::kNoProbe) CHECK(sector.probe[probe].position.y == 1.0);
  });
  CHECK(report.ground_cells_without == 0);
}

TEST_CASE("Grid, AThickWallBetweenTwoRoomsIsNotFilteredThrough") {
  geometry::Surfaces s;
  const auto stone = addMaterial(s, {0.5, 0.5, 0.5});
  addBoxInside(s, {1, 0, 1}, {16, 7, 31}, stone);
  addBoxInside(s, {20, 0, 1}, {50, 7, 31}, stone);  // cells 4 are all wall
  const geometry::Tracer tracer(s);
  placement::PlacementReport report;
  const geometry::PlacedSector sector = place(tracer, {0, 0}, report);
  for (int k = 1; k < 7; ++k) {
    CHECK(sector.grid[placement::cellIndex(4, 0, k)] == geometry::kNoProbe);
    CHECK(sector.grid[placement::cellIndex(3, 0, k)] != geometry::kNoProbe);
    CHECK(sector.grid[placement::cellIndex(5, 0, k)] != geometry::kNoProbe);
  }
}

TEST_CASE("Grid, RoundACorner") {
  geometry::Surfaces s = groundOf({0.5, 0.5, 0.5});
  addBoxOutside(s, {20, 0, 0}, {20.2, 60, 44}, 0);  // a screen with no probe behind it
  placement::PlacementSettings settings;
  settings.remove = {{{20.2, -1, -1}, {65, 90, 65}}};
  const geometry::Tracer tracer(s);
  placement::PlacementReport report;
  const geometry::PlacedSector sector = place(tracer, {0, 0}, report, settings);
  CHECK(report.cells_by_way > 50);
  CHECK(report.ground_cells_without == 0);
  CHECK(sector.grid[placement::cellIndex(6, 0, 2)] != geometry::kNoProbe);
}

TEST_CASE("Grid, ASealedRoomWithoutAProbeHasNone") {
  geometry::Surfaces s = groundOf({0.5, 0.5, 0.5});
  addBoxOutside(s, {20, -1, 20}, {44, 12, 44}, 0);
  addBoxInside(s, {20.2, 0.2, 20.2}, {43.8, 11.8, 43.8}, 0);
  placement::PlacementSettings settings;
  settings.remove = {{{20, -1, 20}, {44, 12, 44}}};
  const geometry::Tracer tracer(s);
  placement::PlacementReport report;
  const geometry::PlacedSector sector = place(tracer, {0, 0}, report, settings);
  for (int k = 6; k < 10; ++k)
    for (int i = 6; i < 10; ++i) CHECK(sector.grid[placement::cellIndex(i, 0, k)] == geometry::kNoProbe);
  CHECK(report.ground_cells_without >= 16);
}

TEST_CASE("Grid, TallAndDeepSectors") {
  geometry::Surfaces s;
  const auto stone = addMaterial(s, {0.5, 0.5, 0.5});
  addQuad(s, {-100, -37, -100}, {0, 0, 200}, {200, 0, 0}, stone);
  addBoxOutside(s, {16, 61, 16}, {48, 62, 48}, stone);
  const geometry::Tracer tracer(s);
  placement::PlacementReport report;
  const geometry::PlacedSector sector = place(tracer, {0, 0}, report);
  CHECK(sector.low_y == -40.0);
  CHECK(sector.cell_height_m == 8.0);
  for (const geometry::Probe& p : sector.probe) {
    CHECK(p.position.y >= sector.low_y);
    CHECK(p.position.y < sector.low_y + geometry::kCells * sector.cell_height_m);
  }
  CHECK(report.ground_cells_without == 0);
  const std::uint8_t above = sector.top[8 + geometry::kCells * 8];
  REQUIRE(above != geometry::kNoProbe);
  CHECK(sector.probe[above].position.y == Approx(63.0));
}

TEST_CASE("Grid, FromAboveEveryCellNamesAProbe") {
  geometry::Surfaces s;
  addQuad(s, {0, 0, 0}, {0, 0, 64}, {17, 0, 0}, addMaterial(s, {0.5, 0.5, 0.5}));
  const geometry::Tracer tracer(s);
  placement::PlacementReport report;
  const geometry::PlacedSector sector = place(tracer, {0, 0}, report);
  for (int k = 0; k < geometry::kCells; ++k) {
    // The fifth column of cells has its middle beside the ground, the fourth above it.
    const std::uint8_t last = sector.top[static_cast<std::size_t>(3 + geometry::kCells * k)];
    CHECK(last < sector.probe.size());
    for (int i = 4; i < geometry::kCells; ++i)
      CHECK(sector.top[static_cast<std::size_t>(i + geometry::kCells * k)] == last);
  }
  CHECK(sector.top[3] != sector.top[3 + geometry::kCells * 15]);
}

TEST_CASE("OcclusionTile, VisibilityAndHeightFromAbove") {
  transfer::SectorProbes probes;
  std::array<std::uint8_t, geometry::kCells * geometry::kCells> top{};
  CHECK_FALSE(sectors::occlusionTileOf(top, probes));
  probes.position = {{1, 5, 1}, {60, 9, 60}};
  probes.transfer.resize(2);
  probes.transfer[0].visibility = {0.25, 0.25, 0.25, 0.0};
  probes.transfer[1].visibility = {1.0, 0.5, 0.0, 0.0};  // the three are alike from above
  top[15 + geometry::kCells * 14] = 1;
  const auto tile = sectors::occlusionTileOf(top, probes);
  REQUIRE(tile);
  CHECK(tile->sky_visibility[0] == Approx(0.25));
  CHECK(tile->probe_y[0] == 5.0);
  CHECK(tile->sky_visibility[15 + geometry::kCells * 14] == Approx(0.5));
  CHECK(tile->probe_y[15 + geometry::kCells * 14] == 9.0);
  CHECK(tile->sky_visibility[14 + geometry::kCells * 15] == Approx(0.25));
}

}  // namespace welkin::tests
