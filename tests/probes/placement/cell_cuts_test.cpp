// SPDX-License-Identifier: Apache-2.0
// No light is filtered through thin walls, and nothing changes in the open. `-s` prints the amounts.
#include <catch2/catch.hpp>
#include <cmath>

#include "probes/sectors/level_light.h"
#include "tests/probes/leak_levels.h"
#include "tests/probes/rooms.h"
#include "tests/probes/skies.h"

namespace welkin::tests {
namespace {

constexpr double kMostLeak = 0.02;  // of the open ground's light: the aim of the method
constexpr std::uint64_t kPlaces = 8;

sectors::SectorFile bakedWith(const geometry::Surfaces& surfaces, placement::Walls walls,
                              build::Fit fit = build::Fit::surfaces) {
  build::BakeSection section;
  section.transfer.fit = fit;
  section.transfer.rays = 64;
  section.transfer.bounces = 0;
  section.transfer.sun = transfer::SunTransfer::none;
  section.probes.walls = walls;
  return build::LevelBake(surfaces, section, uniformSky(1.0), std::nullopt).bake({0, 0}, {});
}

/// Ground that rises along x, in one piece.
geometry::Surfaces slope() {
  geometry::Surfaces s;
  addQuad(s, {-100, -20, -100}, {0, 0, 300}, {300, 60, 0}, addMaterial(s, Number3(0.5)));
  return s;
}

}  // namespace

TEST_CASE("CellCuts, NoLightComesThroughThinWalls") {
  for (const std::string& shape : leakShapes())
    for (std::uint64_t seed = 0; seed < kPlaces; ++seed) {
      const LeakLevel level = leakLevel(shape, seed);
      const Leak leak = leakOf(level, placement::Walls::cut);
      INFO(shape << ", place " << seed << ": mean " << leak.mean << ", worst " << leak.worst << " at "
                 << leak.worst_at.position.x << " " << leak.worst_at.position.y << " " << leak.worst_at.position.z
                 << ", " << leak.cut_cells << " cells, " << leak.bytes << " bytes");
      CHECK(leak.worst < kMostLeak);
      CHECK((!level.sealed || !leak.any));  // exactly 0
      CHECK(leak.without == 0);
      CHECK(leak.bytes < 4096);
    }
}

TEST_CASE("CellCuts, WithoutMasksOrTreesTheSamePlacesLeak") {
  for (const char* shape : {"hall 20 x 12 m", "corridor 3 m", "room with a door"}) {
    INFO(shape);
    CHECK(leakOf(leakLevel(shape, 1), placement::Walls::cut, false).worst > kMostLeak);
    CHECK(leakOf(leakLevel(shape, 1), placement::Walls::ignore).worst > kMostLeak);
  }
}

TEST_CASE("CellCuts, OpenGroundHasNone") {
  for (const geometry::Surfaces& surfaces : {groundOf(Number3(0.5), 200.0), slope()}) {
    const sectors::SectorFile cut = bakedWith(surfaces, placement::Walls::cut);
    const sectors::SectorFile same = bakedWith(surfaces, placement::Walls::ignore);
    CHECK(cut.cuts.empty());
    CHECK(cut.grid == same.grid);
    CHECK(cut.probes.sky == same.probes.sky);
    CHECK(cut.probes.position == same.probes.position);
  }
}

TEST_CASE("CellCuts, FarFromWallsNothingChanges") {
  constexpr double kAway_m = 9.0;  // two cells and the push
  const geometry::Surfaces surfaces = leakLevel("hall, turned by 17", 3).surfaces;
  const model::Sky sky = uniformSky(1.0);
  const std::vector<sectors::SectorFile> cut = {bakedWith(surfaces, placement::Walls::cut, build::Fit::none)};
  const std::vector<sectors::SectorFile> plain = {bakedWith(surfaces, placement::Walls::ignore, build::Fit::none)};
  REQUIRE_FALSE(cut[0].cuts.empty());
  const sectors::LevelLight light(cut, sky, 12.0);
  const sectors::LevelLight before(plain, sky, 12.0);
  const geometry::Tracer tracer(surfaces);
  int looked_at = 0;
  for (double x = 2.3; x < 62.0; x += 0.7)
    for (double z = 2.1; z < 62.0; z += 0.7) {
      const Number3 p(x, 0.0, z);
      bool near = false;
      for (int turn = 0; turn < 64; ++turn) {
        const double a = turn * det::kPi / 32.0;
        near = near || tracer.occluded({x, 0.5, z}, {std::cos(a), 0.0, std::sin(a)}, kAway_m);
      }
      if (near) continue;
      ++looked_at;
      const auto now = light.at(p, {0, 1, 0});
      const auto then = before.at(p, {0, 1, 0});
      REQUIRE((now && then));
      CHECK(now->sky == then->sky);
    }
  CHECK(looked_at > 1000);
}

}  // namespace welkin::tests
