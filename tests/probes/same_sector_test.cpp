// SPDX-License-Identifier: Apache-2.0
// The bytes of a baked sector are the same in every build and for any number of threads.
#include <tbb/task_arena.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "probes/build/level_bake.h"
#include "tests/probes/closed_forms/closed_forms.h"

namespace welkin::tests {
namespace {

/// A house with an emissive wall as its lamp, on ground that ends within reach.
geometry::Surfaces house() {
  geometry::Surfaces s = groundOf(Number3(0.3, 0.4, 0.2), 90.0);
  const auto wall = addMaterial(s, Number3(0.7, 0.5, 0.4));
  const auto lamp = addMaterial(s, Number3(0.1), true, Number3(3.0, 2.0, 1.0));
  addBoxOutside(s, {20.3, 0.0, 15.1}, {31.7, 6.0, 29.9}, wall);
  addQuad(s, {8.0, 1.0, 40.0}, {4.0, 0.0, 0.0}, {0.0, 2.0, 1.0}, lamp);
  return s;
}

model::Sky day() {
  model::Sky sky;
  sky.ground_albedo = Number3(0.2, 0.1, 0.3);
  sky.sun.path.key_time_h = {6.0, 12.0, 18.0};
  sky.sun.path.key_azimuth_rad = {1.5, 3.1, 4.7};
  sky.sun.path.key_elevation_rad = {-0.1, 1.1, -0.2};
  return sky;
}

std::string bytesOf(int threads) {
  tbb::task_arena arena(threads);
  return arena.execute([] {
    const build::LevelBake level(house(), build::BakeSection{}, day(), std::nullopt);
    const auto bytes = sectors::encodeSector(level.bake({0, 0}, {}));
    return base::textOf(base::hashOf(std::span<const std::byte>(bytes)));
  });
}

}  // namespace

TEST_CASE("SameSector, ItsBytesAreTheGoldenOnesForAnyThreads") {
  std::ifstream file(WELKIN_GOLDEN + std::string("/sector.txt"));
  std::string golden;
  REQUIRE(file >> golden);
  for (const int threads : {1, 2, 5}) CHECK(bytesOf(threads) == golden);
}

}  // namespace welkin::tests
