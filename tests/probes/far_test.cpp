// SPDX-License-Identifier: Apache-2.0
// The same light anywhere in the world: the bytes of a level moved by whole sectors, the light of one moved anyhow.
#include <catch2/catch.hpp>

#include "probes/build/level_bake.h"
#include "probes/transfer/transfer_basis.h"
#include "rooms.h"
#include "skies.h"

namespace welkin::tests {
namespace {

/// An oblique wall of two colours, a lamp, a bush and a light on ground that ends in the next sector.
geometry::Surfaces yard() {
  geometry::Surfaces s = groundOf(Number3(0.3, 0.4, 0.2), 90.0);
  addQuad(s, {20.3, 0, 15.1}, {7.7, 0, 3.1}, {0, 5, 0}, addMaterial(s, Number3(0.8, 0.2, 0.1), true));
  addQuad(s, {20.3, 0, 15.1}, {-2.3, 0, 9.1}, {0.4, 5, 0}, addMaterial(s, Number3(0.1, 0.7, 0.3), true));
  addQuad(s, {23.1, 1, 24.7}, {1, 0, 0}, {0, 0.5, 0.2}, addMaterial(s, Number3(0.1), true, Number3(3, 2, 1)));
  s.object.push_back({"bush", geometry::Role::vegetation});
  const std::size_t first = s.triangle.size();
  addBoxOutside(s, {40.2, 0.1, 30.7}, {43.4, 2.2, 35.1}, addMaterial(s, Number3(0.2, 0.5, 0.1)));
  for (std::size_t i = first; i < s.triangle.size(); ++i) s.triangle[i].object = 1;
  s.light.push_back({{21.5, 2.25, 19.5}, Number3(5.0)});
  for (auto& p : s.position)
    for (double& v : p) v = std::round(v * 0x1p24) * 0x1p-24;  // as the loader does
  return s;
}

build::BakeSection section() {
  build::BakeSection section;
  section.transfer.rays = 512;
  section.transfer.reach_m = 48.0;
  section.probes.spacing_m = 5.0;  // no part of a sector's side
  section.probes.add = {{22.1, 1.3, 20.3}};
  section.probes.room = {{{19.5, -1, 14.1}, {30.3, 6, 25.7}}};
  return section;
}

geometry::Surfaces moved(geometry::Surfaces s, const Number3& by) {
  for (auto& p : s.position)
    for (std::size_t axis = 0; axis < 3; ++axis) p[axis] += by[static_cast<int>(axis)];
  for (geometry::StaticLight& light : s.light) light.position += by;
  return s;
}

build::BakeSection moved(build::BakeSection section, const Number3& by) {
  for (Number3& p : section.probes.add) p += by;
  for (geometry::Box& box : section.probes.room) box = {box.low + by, box.high + by};
  return section;
}

model::Sky day() {
  model::Sky sky = clearSky(1.1, 0.8);
  sky.ground_albedo = Number3(0.2, 0.1, 0.3);
  return sky;
}

/// The sector with the wall, baked where the level was moved to.
sectors::SectorFile bakedAt(const Number3& by, const build::BakeSection& of = section()) {
  const build::LevelBake level(moved(yard(), by), moved(of, by), day(), std::nullopt);
  return level.bake(geometry::sectorAt(by + Number3(22.1, 1.3, 20.3)), {});
}

std::vector<std::byte> bytesWithoutPlace(sectors::SectorFile file) {
  file.id = {0, 0};
  return sectors::encodeSector(file);
}

}  // namespace

TEST_CASE("Far, ALevelMovedByWholeSectorsHasTheSameBytes") {
  const sectors::SectorFile home = bakedAt(Number3(0.0));
  CHECK(home.id == geometry::SectorId{0, 0});
  CHECK(home.probes.probes() > 40);
  REQUIRE(home.local);
  REQUIRE(home.room.size() == 1);
  CHECK(home.room[0].probe != geometry::kNoProbe);
  for (const auto& [x, z] : {std::pair{1, 0}, std::pair{-1, -1}, std::pair{1562, -700}, std::pair{-15600, 15620}}) {
    INFO(x << " " << z);
    const sectors::SectorFile far = bakedAt({geometry::kSector_m * x, 0.0, geometry::kSector_m * z});
    CHECK(far.id == geometry::SectorId{x, z});
    CHECK(bytesWithoutPlace(far) == bytesWithoutPlace(home));
  }
}

TEST_CASE("Far, ALevelMovedAnyhowHasTheSameLight") {
  build::BakeSection exact = section();
  exact.transfer.rays = 131072;
  exact.transfer.fit = build::Fit::none;  // whose points are others at other places
  exact.probes.spacing_m = exact.probes.coverage_m = exact.probes.minimum_separation_m = 64.0;  // few probes
  const auto lightOf = [&](const Number3& by) {
    const sectors::SectorFile file = bakedAt(by, exact);
    return std::pair(transfer::decodedProbes(file.probes, file.id), file.error);
  };
  const auto [home, home_error] = lightOf(Number3(0.0));
  // The probe by hand is the first of its sector.
  const double allowed = 1.5 * std::hypot(home_error.sampling, home_error.sampling) + 2.0 * home_error.encoding.sky;
  CHECK(allowed < 0.02);
  for (const Number3& by : {Number3(20.3, 5.7, 25.9), Number3(100000.3, 0.0, -7.1), Number3(0.0, 100000.0, 0.0),
                            Number3(-870000.7, -900000.3, 912345.6), Number3(13.0, 999000.0, 999900.0)}) {
    INFO(by.x << " " << by.y << " " << by.z);
    const auto [far, error] = lightOf(by);
    const Number3 place = far.position[0] - by;
    CHECK(std::abs(place.x - 22.1) < 1e-3);  // half a step of the encoding
    CHECK(std::abs(place.y - 1.3) < 1e-3);
    CHECK(std::abs(place.z - 20.3) < 1e-3);
    for (std::size_t b = 0; b < transfer::kDirections; ++b) {
      CHECK(std::abs(far.transfer[0].visibility[b] - home.transfer[0].visibility[b]) < allowed);
      for (std::size_t k = 0; k < 4; ++k)
        for (int c = 0; c < 3; ++c)
          CHECK(std::abs(far.transfer[0].sky[b][k][c] - home.transfer[0].sky[b][k][c]) < allowed);
    }
  }
}

TEST_CASE("Far, TheReferenceIsTheSame") {
  const model::Sky sky = day();
  const reference::DistantLight distant(sky, 12.0);
  const reference::ReferenceSettings settings{16384, 2, 0};
  const Number3 position(21.7, 0.0, 18.3);
  const auto irradianceAt = [&](const Number3& by) {
    geometry::Surfaces level = moved(yard(), by);
    if (!(by == Number3(0.0))) addQuad(level, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 0);  // the level begins at the origin
    const geometry::Tracer tracer(level, position + by);
    return reference::traceReference(tracer, distant, {}, position + by, {0, 1, 0}, settings).total;
  };
  const reference::Estimate home = irradianceAt(Number3(0.0));
  for (const Number3& by : {Number3(64000.0, 0.0, 0.0), Number3(100000.3, 5.1, -7.1), Number3(-99.9, 9e5, 9e5)}) {
    const reference::Estimate far = irradianceAt(by);
    for (int c = 0; c < 3; ++c) {
      // The same paths: only those differ that rounding sends another way.
      CHECK(std::abs(far.value[c] - home.value[c]) < home.standard_error[c]);
      CHECK(home.standard_error[c] < 0.01 * home.value[c]);
    }
  }
}

}  // namespace welkin::tests
