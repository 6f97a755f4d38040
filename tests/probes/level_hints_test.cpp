// SPDX-License-Identifier: Apache-2.0
// Hints at levels inside of a sky dome, and in centimetres.
#include "probes/build/level_hints.h"

#include <catch2/catch.hpp>

#include "rooms.h"

namespace welkin::tests {

using f64::Number3;
namespace {

/// Ground of 60 x 60 m, and a second object made by `add`.
template <typename Add>
geometry::Surfaces groundAnd(const Add& add) {
  geometry::Surfaces s = groundOf(Number3(0.5), 30.0);
  s.object.push_back({"other", geometry::Role::fixed});
  const std::size_t first = s.triangle.size();
  add(s);
  for (std::size_t i = first; i < s.triangle.size(); ++i) s.triangle[i].object = 1;
  return s;
}

}  // namespace

TEST_CASE("LevelHints, ABoxAroundALevelIsADome") {
  const auto boxOf = [](double half, bool inside) {
    return build::domeAround(groundAnd([&](geometry::Surfaces& s) {
      const auto add = inside ? addBoxInside : addBoxOutside;
      add(s, Number3(-half), Number3(half), 0);
    }));
  };
  CHECK(boxOf(100.0, true) == "other");
  CHECK(boxOf(100.0, false) == "other");
  CHECK(boxOf(37.0, true) == "other");  // 7 m of room, a tenth is 6
  CHECK_FALSE(boxOf(35.0, true));       // a hall about its floor
  CHECK_FALSE(boxOf(20.0, true));
  CHECK_FALSE(build::domeAround(groundOf(Number3(0.5), 30.0)));
  CHECK_FALSE(build::domeAround({}));
}

TEST_CASE("LevelHints, WallsWithoutARoofAreNoDome") {
  CHECK_FALSE(build::domeAround(groundAnd([](geometry::Surfaces& s) {
    addBoxInside(s, Number3(-100.0), Number3(100.0), 0);
    s.triangle.erase(s.triangle.begin() + 2 + 2, s.triangle.begin() + 2 + 4);  // its top
  })));
  geometry::Surfaces trees =
      groundAnd([](geometry::Surfaces& s) { addBoxInside(s, Number3(-100.0), Number3(100.0), 0); });
  trees.object[1].role = geometry::Role::vegetation;
  CHECK_FALSE(build::domeAround(trees));
}

TEST_CASE("LevelHints, LargeLevelsOfLongTrianglesSeemToBeInCentimetres") {
  const geometry::Surfaces plain = groundOf(Number3(0.5), 3000.0);
  CHECK(build::seemsInCentimetres(plain, 8836));
  CHECK_FALSE(build::seemsInCentimetres(plain, 255));
  geometry::Surfaces houses = plain;
  for (int i = 0; i < 2; ++i) addBoxOutside(houses, {9.0 * i, 0, 0}, {9.0 * i + 5, 3, 5}, 0);
  CHECK_FALSE(build::seemsInCentimetres(houses, 8836));
}

}  // namespace welkin::tests
