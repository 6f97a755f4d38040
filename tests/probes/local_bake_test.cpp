// SPDX-License-Identifier: Apache-2.0
// Local transfer in a sector's bake: which sectors get it, which virtual lights they have, and what comes of them.
#include "probes/build/local_bake.h"

#include <catch2/catch.hpp>
#include <numeric>

#include "placed.h"
#include "probes/build/level_bake.h"
#include "probes/transfer/local_transfer.h"
#include "sky/error.h"

namespace welkin::tests {
namespace {

using namespace probes;

const TransferProgress kGoOn = [](std::uint64_t) {};

BakeSection sectionWithin(double reach_m) {
  BakeSection section;
  section.probes.spacing_m = 16.0;
  section.transfer.rays = 64;
  section.transfer.reach_m = reach_m;
  return section;
}

SectorSettings settingsWithin(double reach_m) {
  SectorSettings settings;
  settings.section = sectionWithin(reach_m);
  return settings;
}

/// Ground with a wall along z, nearer to one neighbour than to the other.
Surfaces groundWithWall() {
  Surfaces s = groundOf({0.6, 0.5, 0.4}, 150.0);
  addBoxOutside(s, {40, -1, 10}, {41, 4, 50}, addMaterial(s, {0.3, 0.6, 0.9}));
  return s;
}

std::vector<Number3> positionsOf(const std::vector<Probe>& probes) {
  std::vector<Number3> positions;
  for (const Probe& p : probes) positions.push_back(p.position);
  return positions;
}

}  // namespace

TEST_CASE("LocalBake, SettingsAndLightsSayWhetherThereIsAny") {
  using Where = LocalLights::Where;
  const Surfaces dark = groundOf(Number3(0.5));
  Surfaces lit = dark;
  lit.light.push_back({{1, 2, 3}, Number3(4.0)});
  const auto has = [](Where where, const Surfaces& level, int bounces = 1) {
    TransferSection transfer;
    transfer.local_lights = {where, {{-1, 2}, {0, 0}, {0, 1}}};
    transfer.bounces = bounces;
    return hasLocalTransfer({0, 0}, transfer, level);
  };
  CHECK_FALSE(has(Where::near_lights, dark));
  CHECK(has(Where::near_lights, lit));
  Surfaces spotted = dark;
  spotted.spot.push_back({1, 2, 3});
  CHECK(has(Where::near_lights, spotted));
  CHECK(has(Where::everywhere, dark));
  CHECK_FALSE(has(Where::nowhere, lit));
  CHECK_FALSE(has(Where::everywhere, lit, 0));
  CHECK(has(Where::listed, dark));
  TransferSection transfer;
  transfer.local_lights = {Where::listed, {{-1, 2}, {0, 1}}};
  CHECK_FALSE(hasLocalTransfer({0, 0}, transfer, lit));
  // Within reach of the sector's square.
  transfer.local_lights = {};
  transfer.reach_m = 64.0;
  CHECK(hasLocalTransfer({1, -1}, transfer, lit));
  CHECK_FALSE(hasLocalTransfer({2, 0}, transfer, lit));
  CHECK_FALSE(hasLocalTransfer({0, -2}, transfer, lit));
}

TEST_CASE("LocalBake, VirtualLightsAreTheProbesOfNineSectorsInOrder") {
  const Surfaces s = groundWithWall();
  const Tracer tracer(s);
  const BakeSection section = sectionWithin(64.0);
  const PlacedSector sector = place(s, {0, 0}, section.probes);
  std::vector<Number3> expected;
  for (int x = -1; x <= 1; ++x)
    for (int z = -1; z <= 1; ++z)
      for (const Number3& p : positionsOf(place(s, {x, z}, section.probes).probe)) expected.push_back(p);
  REQUIRE(expected.size() > 9 * 4);
  const std::vector<Number3> lights = virtualLights(s, sector, section);
  REQUIRE(lights.size() == expected.size());
  for (std::size_t i = 0; i < lights.size(); ++i)
    for (int c = 0; c < 3; ++c) CHECK(lights[i][c] == expected[i][c]);
}

TEST_CASE("LocalBake, VirtualLightsAreProbesOfTheirSectorsBakes") {
  // What changes a neighbour's probes lies out of reach of 0_0: a wall of one side, whose back all ground beyond it
  // sees, and a bush over both.
  Surfaces s = groundWithWall();
  addQuad(s, {80, -1, -60}, {0, 0, 200}, {0, 30, 0}, addMaterial(s, Number3(0.5)));
  s.object.push_back({"bush", Role::vegetation});
  const std::size_t first = s.triangle.size();
  addBoxOutside(s, {70, 2, 10}, {100, 9, 20}, addMaterial(s, Number3(0.2)));
  addBoxOutside(s, {-60, 2, 10}, {-50, 20, 20}, addMaterial(s, Number3(0.2)));  // of the same bush, out of 1_0's reach
  for (std::size_t i = first; i < s.triangle.size(); ++i) s.triangle[i].object = 1;
  BakeSection section = sectionWithin(8.0);
  section.transfer.local_lights.where = LocalLights::Where::everywhere;
  section.probes.spacing_m = 4.0;
  section.probes.add = {{71, 3, 40}, {130, 1, 30}};
  const LevelBake level(s, section, sky::Sky{}, std::nullopt);
  const SectorFile file = level.bake({0, 0}, [](std::uint64_t) { return true; });
  std::size_t of_neighbours = 0;
  for (const Number3& light : decodedLocal(file.local->encoded).light) {
    const PlacedSector placed = level.place(sectorAt(light));
    const double nearest = std::accumulate(
        placed.probe.begin(), placed.probe.end(), 1e9,
        [&](double d, const Probe& p) { return std::min(d, std::sqrt(dot(p.position - light, p.position - light))); });
    CHECK(nearest < 1e-4);  // float32 in the file
    if (placed.id != SectorId{0, 0}) ++of_neighbours;
  }
  CHECK(of_neighbours > 10);
}

TEST_CASE("LocalBake, VirtualLightsLieWithinReach") {
  const Surfaces s = groundWithWall();
  const Tracer tracer(s);
  for (const double reach_m : {0.0, 20.0}) {
    const BakeSection section = sectionWithin(reach_m);
    const PlacedSector sector = place(s, {0, 0}, section.probes);
    const std::vector<Number3> lights = virtualLights(s, sector, section);
    CHECK((lights.size() > sector.probe.size()) == (reach_m > 0.0));
    CHECK(lights.size() >= sector.probe.size());
    for (const Number3& p : lights) CHECK(columnOf({0, 0}, reach_m).holds(p));
  }
}

TEST_CASE("LocalBake, HoldsWhatTheTracerFinds") {
  const Surfaces s = groundWithWall();
  const Tracer tracer(s);
  SectorSettings section = settingsWithin(64.0);
  section.max_error = 0.01;  // of no effect: the number of rays is fixed
  const PlacedSector sector = place(s, {0, 0}, section.section.probes);
  const BakedLocal baked = bakeLocal(tracer, s, sector, section, kGoOn);
  LocalSettings settings;
  settings.rays = 64;
  settings.nearest_m = kNearest_m;
  settings.reach_m = 64.0;
  const auto traced = LocalTransferTracer(tracer, settings, virtualLights(s, sector, section.section)).trace(sector);
  std::uint64_t rays = 0;
  std::size_t transfers = 0;
  double worst = 0.0;
  for (const LocalProbe& probe : traced) {
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
  const SectorLocal decoded = decodedLocal(baked.encoded);
  REQUIRE(decoded.probe.size() == sector.probe.size());
  for (std::size_t i = 0; i < traced.size(); ++i) {
    REQUIRE(decoded.probe[i].size() == traced[i].transfer.size());
    for (std::size_t j = 0; j < decoded.probe[i].size(); ++j) {
      // Half a step of each of the three channels, of a scale up to 1/128 above the largest number; no coefficient of
      // a radiance is above sqrt 3 times coefficient 0.
      const double influence = traced[i].transfer[j].influence();
      CHECK(decoded.probe[i][j].influence() == Approx(influence).epsilon(0.0).margin(2.7 * influence / 127));
    }
  }
}

TEST_CASE("LocalBake, EndsWhenTold") {
  const Surfaces s = groundWithWall();
  const Tracer tracer(s);
  const SectorSettings settings = settingsWithin(0.0);
  const TransferProgress stop = [](std::uint64_t) { throw Error(ExitStatus::interrupted, "enough"); };
  CHECK_THROWS_AS(bakeLocal(tracer, s, place(s, {0, 0}, settings.section.probes), settings, stop), Error);
}

TEST_CASE("LocalBake, RaysAreThoseThatTheBudgetTakes") {
  const Surfaces s = groundWithWall();
  const Tracer tracer(s);
  SectorSettings settings = settingsWithin(16.0);
  settings.section.transfer.rays.reset();
  const PlacedSector sector = place(s, {0, 0}, settings.section.probes);
  std::uint64_t rays = 0;
  for (const double budget : {0.5, 0.2, 0.1}) {
    settings.max_error = budget;
    const BakedLocal baked = bakeLocal(tracer, s, sector, settings, kGoOn);
    CHECK(baked.sampling.error <= budget);
    CHECK(baked.sampling.error > 0.2 * budget);  // no more than doubled once too often
    CHECK(baked.sampling.rays > rays);
    rays = baked.sampling.rays;
  }
}

}  // namespace welkin::tests
