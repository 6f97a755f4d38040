// SPDX-License-Identifier: Apache-2.0
// The files of a baked level's sectors can be read, whatever the level, and have the bytes that were planned.
#include <catch2/catch.hpp>

#include "probes/build/level_bake.h"
#include "rooms.h"
#include "skies.h"

namespace welkin::tests {
namespace {

/// The sectors with probes, as read from their files.
std::vector<sectors::SectorFile> bakedOf(const geometry::Surfaces& surfaces,
                                         const placement::PlacementSettings& settings = {}) {
  build::BakeSection section;
  section.probes = settings;
  section.transfer.rays = 64;
  const build::LevelBake level(surfaces, section, uniformSky(1.0), std::nullopt);
  std::vector<sectors::SectorFile> sectors;
  for (const geometry::SectorId id : level.sectors()) {
    const auto bytes = sectors::encodeSector(level.bake(id, {}));
    sectors::SectorFile read = sectors::decodeSector(bytes, "the sector");
    if (read.probes.probes() > 0) sectors.push_back(std::move(read));
  }
  return sectors;
}

geometry::Surfaces board() {
  geometry::Surfaces s;
  addQuad(s, {10.05, 2, 10}, {0, 0, 12}, {0.1, 0, 0}, addMaterial(s, Number3(0.5)));
  return s;
}

}  // namespace

TEST_CASE("SectorBake, ProbesWithoutGroundBelowTheLinesCanBeRead") {
  SECTION("a board between the lines of the lattice") {
    const auto sectors = bakedOf(board());
    REQUIRE(sectors.size() == 1);
    for (const std::uint8_t probe : sectors[0].top) CHECK(probe < sectors[0].probes.probes());
  }
  SECTION("by hand, where there is nothing") {
    placement::PlacementSettings settings;
    settings.add = {{130.0, 5.0, -60.0}, {190.0, 5.0, -2.0}};
    const auto sectors = bakedOf(board(), settings);
    REQUIRE(sectors.size() == 2);
    const sectors::SectorFile& bare = sectors[1];
    REQUIRE(bare.id == geometry::SectorId{2, -1});
    // The nearest probes in cells: the one in the corner, and the one opposite.
    CHECK(bare.top[0] == 0);
    CHECK(bare.top[1 + geometry::kCells * 3] == 0);
    CHECK(bare.top[15 + geometry::kCells * 15] == 1);
    CHECK(bare.top[15 + geometry::kCells * 9] == 1);
  }
  SECTION("above vegetation alone") {
    geometry::Surfaces s = board();
    s.object.push_back({"tree", geometry::Role::vegetation});
    addQuad(s, {100, 8, 100}, {0, 0, 6}, {6, 0, 0}, 0);
    for (std::size_t i = s.triangle.size() - 2; i < s.triangle.size(); ++i) s.triangle[i].object = 1;
    CHECK(bakedOf(s).size() == 2);
  }
  SECTION("under a slab whose top has none") {
    geometry::Surfaces s;
    addBoxOutside(s, {-60, 0, -60}, {60, 1, 60}, addMaterial(s, Number3(0.5)));
    placement::PlacementSettings settings;
    settings.remove = {{{-100, -100, -100}, {100, 100, 100}}};
    settings.add = {{20, -5, 20}};
    const auto sectors = bakedOf(s, settings);
    REQUIRE(sectors.size() == 1);
    for (const std::uint8_t probe : sectors[0].top) CHECK(probe == 0);
  }
}

TEST_CASE("SectorBake, HasTheBytesThatWerePlanned") {
  constexpr std::size_t kZeros = 128;  // FlatBuffers stores no field that is 0: counts and errors
  geometry::Surfaces surfaces = groundOf(Number3(0.5), 60.0);
  for (const double x : {-40.0, 12.0})  // coloured blocks, so that the sun has ten modes and more
    for (const double z : {-35.0, 22.0})
      addBoxOutside(surfaces, {x, 0, z}, {x + 9, 7, z + 5}, addMaterial(surfaces, Number3(0.8, 0.3, 0.1)));
  model::Sky sky = clearSky(1.0, 0.7);
  sky.sun.path = model::sunPathFromPlace(43.5, 145.0, 9.0, 2026, 172);
  build::BakeSection section;
  section.transfer.rays = 64;
  SECTION("the sun in modes") {}
  SECTION("sun and moon in modes") {
    sky.moon = sky.sun;
  }
  SECTION("a sun without modes") {
    section.transfer.sun = transfer::SunTransfer::sh;
  }
  bool emits = false;
  SECTION("light from a surface, and a room") {
    emits = true;
    addQuad(surfaces, {10, 3, 10}, {1, 0, 0}, {0, 0, 1}, addMaterial(surfaces, Number3(0.5), true, Number3(2.0)));
    section.probes.room = {{{5, -1, 5}, {20, 4, 20}}};
  }
  const build::LevelBake level(surfaces, section, sky, std::nullopt);
  REQUIRE(level.sectors().size() == 4);
  for (const geometry::SectorId id : level.sectors()) {
    const build::SectorPlan plan = level.plan(id);
    sectors::SectorFile baked = level.bake(id, {});
    baked.cuts = {};  // a plan does not trace what they depend on
    const std::size_t bytes = sectors::encodeSector(baked).size();
    INFO(plan.probes << " probes, " << plan.bytes << " bytes planned, " << bytes << " baked");
    CHECK(plan.probes == baked.probes.probes());
    const bool dark = emits && baked.probes.emitted.empty();  // a plan does not trace whether the lamp reaches a probe
    CHECK(plan.bytes <= bytes + (dark ? 14 * plan.probes + 16 : 0));
    CHECK(plan.bytes + kZeros >= bytes);
  }
}

}  // namespace welkin::tests
