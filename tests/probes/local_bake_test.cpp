// SPDX-License-Identifier: Apache-2.0
// Local transfer in a sector's bake: the sectors that get it, their virtual lights, and its results.
#include "probes/build/local_bake.h"

#include <catch2/catch.hpp>
#include <numeric>

#include "probes/build/level_bake.h"
#include "probes/transfer/local_transfer.h"
#include "sky/base/error.h"
#include "tests/probes/placement/placed.h"

namespace welkin::tests {
namespace {

build::BakeSection sectionWithin(double reach_m) {
  build::BakeSection section;
  section.probes.spacing_m = 16.0;
  section.transfer.rays = 64;
  section.transfer.reach_m = reach_m;
  return section;
}

build::SectorSettings settingsWithin(double reach_m) {
  build::SectorSettings settings;
  settings.section = sectionWithin(reach_m);
  return settings;
}

/// Ground with a wall along z, nearer to one neighbour than to the other.
geometry::Surfaces groundWithWall() {
  geometry::Surfaces s = groundOf({0.6, 0.5, 0.4}, 150.0);
  addBoxOutside(s, {40, -1, 10}, {41, 4, 50}, addMaterial(s, {0.3, 0.6, 0.9}));
  return s;
}

std::vector<Number3> positionsOf(const std::vector<geometry::Probe>& probes) {
  std::vector<Number3> positions;
  for (const geometry::Probe& p : probes) positions.push_back(p.position);
  return positions;
}

}  // namespace

TEST_CASE("LocalBake, SettingsAndLightsSayWhetherThereIsAny") {
  using Where = build::LocalLights::Where;
  const geometry::Surfaces dark = groundOf(Number3(0.5));
  geometry::Surfaces lit = dark;
  lit.light.push_back({{1, 2, 3}, Number3(4.0)});
  const auto has = [](Where where, const geometry::Surfaces& level, int bounces = 1) {
    build::TransferSection transfer;
    transfer.local_lights = {where, {{-1, 2}, {0, 0}, {0, 1}}};
    transfer.bounces = bounces;
    return build::hasLocalTransfer({0, 0}, transfer, level);
  };
  CHECK_FALSE(has(Where::near_lights, dark));
  CHECK(has(Where::near_lights, lit));
  geometry::Surfaces spotted = dark;
  spotted.light.push_back({{1, 2, 3}, Number3(4.0)});
  spotted.light[0].directional = true;  // shines everywhere, and stands nowhere
  CHECK_FALSE(has(Where::near_lights, spotted));
  CHECK(has(Where::everywhere, dark));
  CHECK_FALSE(has(Where::nowhere, lit));
  CHECK_FALSE(has(Where::everywhere, lit, 0));
  CHECK(has(Where::listed, dark));
  build::TransferSection transfer;
  transfer.local_lights = {Where::listed, {{-1, 2}, {0, 1}}};
  CHECK_FALSE(build::hasLocalTransfer({0, 0}, transfer, lit));
  // Within reach of the sector's square.
  transfer.local_lights = {};
  transfer.reach_m = 64.0;
  CHECK(build::hasLocalTransfer({1, -1}, transfer, lit));
  CHECK_FALSE(build::hasLocalTransfer({2, 0}, transfer, lit));
  CHECK_FALSE(build::hasLocalTransfer({0, -2}, transfer, lit));
}

TEST_CASE("LocalBake, VirtualLightsAreTheProbesOfNineSectorsInOrder") {
  const geometry::Surfaces s = groundWithWall();
  const geometry::Tracer tracer(s);
  const build::BakeSection section = sectionWithin(64.0);
  const geometry::PlacedSector sector = place(s, {0, 0}, section.probes);
  std::vector<Number3> expected;
  for (int x = -1; x <= 1; ++x)
    for (int z = -1; z <= 1; ++z)
      for (const Number3& p : positionsOf(place(s, {x, z}, section.probes).probe)) expected.push_back(p);
  REQUIRE(expected.size() > 9 * 4);
  const std::vector<Number3> lights = build::virtualLights(s, sector, section);
  REQUIRE(lights.size() == expected.size());
  for (std::size_t i = 0; i < lights.size(); ++i)
    for (int c = 0; c < 3; ++c) CHECK(lights[i][c] == expected[i][c]);
}

TEST_CASE("LocalBake, VirtualLightsAreProbesOfTheirSectorsBakes") {
  // The changes to a neighbour's probes lie out of reach of 0_0: a one-sided wall, whose back all ground beyond it
  // sees, and a bush over both.
  geometry::Surfaces s = groundWithWall();
  addQuad(s, {80, -1, -60}, {0, 0, 200}, {0, 30, 0}, addMaterial(s, Number3(0.5)));
  s.object.push_back({"bush", geometry::Role::vegetation});
  const std::size_t first = s.triangle.size();
  addBoxOutside(s, {70, 2, 10}, {100, 9, 20}, addMaterial(s, Number3(0.2)));
  addBoxOutside(s, {-60, 2, 10}, {-50, 20, 20}, addMaterial(s, Number3(0.2)));  // same bush, out of 1_0's reach
  for (std::size_t i = first; i < s.triangle.size(); ++i) s.triangle[i].object = 1;
  build::BakeSection section = sectionWithin(8.0);
  section.transfer.local_lights.where = build::LocalLights::Where::everywhere;
  section.probes.spacing_m = 4.0;
  section.probes.add = {{71, 3, 40}, {130, 1, 30}};
  const build::LevelBake level(s, section, model::Sky{}, std::nullopt);
  const sectors::SectorFile file = level.bake({0, 0}, {});
  std::size_t of_neighbours = 0;
  for (const Number3& light : transfer::decodedLocal(file.local->encoded).light) {
    const geometry::PlacedSector placed = level.place(geometry::sectorAt(light));
    const double nearest =
        std::accumulate(placed.probe.begin(), placed.probe.end(), 1e9, [&](double d, const geometry::Probe& p) {
          return std::min(d, std::sqrt(dot(p.position - light, p.position - light)));
        });
    CHECK(nearest < 1e-4);  // float32 in the file
    if (placed.id != geometry::SectorId{0, 0}) ++of_neighbours;
  }
  CHECK(of_neighbours > 10);
}

TEST_CASE("LocalBake, VirtualLightsLieWithinReach") {
  const geometry::Surfaces s = groundWithWall();
  const geometry::Tracer tracer(s);
  for (const double reach_m : {0.0, 20.0}) {
    const build::BakeSection section = sectionWithin(reach_m);
    const geometry::PlacedSector sector = place(s, {0, 0}, section.probes);
    const std::vector<Number3> lights = build::virtualLights(s, sector, section);
    CHECK((lights.size() > sector.probe.size()) == (reach_m > 0.0));
    CHECK(lights.size() >= sector.probe.size());
    for (const Number3& p : lights) CHECK(geometry::columnOf({0, 0}, reach_m).holds(p));
  }
}

TEST_CASE("LocalBake, HoldsWhatTheTracerFinds") {
  const geometry::Surfaces s = groundWithWall();
  const geometry::Tracer tracer(s);
  build::SectorSettings section = settingsWithin(64.0);
  section.max_error = 0.01;  // no effect, as the number of rays is fixed
  const geometry::PlacedSector sector = place(s, {0, 0}, section.section.probes);
  const sectors::BakedLocal baked = build::bakeLocal(tracer, s, sector, section, {});
  transfer::LocalSettings settings;
  settings.rays = 64;
  settings.nearest_m = build::kNearest_m;
  settings.reach_m = 64.0;
  const auto traced =
      transfer::LocalTransferTracer(tracer, settings, build::virtualLights(s, sector, section.section)).trace(sector);
  std::uint64_t rays = 0;
  std::size_t transfers = 0;
  double worst = 0.0;
  for (const transfer::LocalProbe& probe : traced) {
    rays += probe.rays;
    transfers += probe.transfer.size();
    worst = std::max(worst, probe.error);
  }
  CHECK(baked.sampling.rays == rays);
  CHECK(baked.sampling.error == worst);
  CHECK(traced[baked.sampling.probe].error == worst);
  CHECK(baked.thinning.kept == transfers);
  CHECK(baked.thinning.dropped == 0);
  CHECK(worst > 0.01);
  const transfer::SectorLocal decoded = transfer::decodedLocal(baked.encoded);
  REQUIRE(decoded.probe.size() == sector.probe.size());
  for (std::size_t i = 0; i < traced.size(); ++i) {
    REQUIRE(decoded.probe[i].size() == traced[i].transfer.size());
    for (std::size_t j = 0; j < decoded.probe[i].size(); ++j) {
      // Half a step of each of the three channels, at a scale up to 1/128 above the largest number. No coefficient of a
      // radiance is above sqrt 3 times coefficient 0.
      const double influence = traced[i].transfer[j].influence();
      CHECK(decoded.probe[i][j].influence() == Approx(influence).epsilon(0.0).margin(2.7 * influence / 127));
    }
  }
}

TEST_CASE("LocalBake, EndsWhenTold") {
  const geometry::Surfaces s = groundWithWall();
  const geometry::Tracer tracer(s);
  const build::SectorSettings settings = settingsWithin(0.0);
  const base::Progress stop([](const base::Progress::Stage&, base::Progress::Event) { return false; });
  CHECK_THROWS_AS(build::bakeLocal(tracer, s, place(s, {0, 0}, settings.section.probes), settings, stop), base::Error);
}

TEST_CASE("LocalBake, RaysAreThoseThatTheBudgetTakes") {
  const geometry::Surfaces s = groundWithWall();
  const geometry::Tracer tracer(s);
  build::SectorSettings settings = settingsWithin(16.0);
  settings.section.transfer.rays.reset();
  const geometry::PlacedSector sector = place(s, {0, 0}, settings.section.probes);
  std::uint64_t rays = 0;
  for (const double budget : {0.5, 0.2, 0.1}) {
    settings.max_error = budget;
    const sectors::BakedLocal baked = build::bakeLocal(tracer, s, sector, settings, {});
    CHECK(baked.sampling.error <= budget);
    CHECK(baked.sampling.error > 0.2 * budget);  // not doubled more than once too often
    CHECK(baked.sampling.rays > rays);
    rays = baked.sampling.rays;
  }
}

}  // namespace welkin::tests
