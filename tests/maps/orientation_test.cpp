// SPDX-License-Identifier: Apache-2.0
// Orientations of maps: the inverse of every engine's own lookup.
#include "maps/orientation.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "engine_lookup.h"

namespace welkin::tests {
namespace {

using det::Number3;

constexpr int kDirections = 2000;
constexpr double kDouble = 1e-12;   // rounding of formulas in double
constexpr double kNearPole = 2e-8;  // acos near 1 loses half the digits

maps::Orientation orientationFor(const EngineLookup& lookup) {
  return maps::orientationOf(lookup.engine).value_or(maps::welkinOrientation());
}

}  // namespace

TEST_CASE("Orientation, CubesAreTheInverseOfEveryEnginesLookup") {
  std::mt19937 random(1);
  for (const EngineLookup& lookup : engineLookups()) {
    const maps::Orientation orientation = orientationFor(lookup);
    CAPTURE(lookup.engine);
    for (int i = 0; i < kDirections; ++i) {
      const Number3 direction = randomDirection(random);
      const CubePlace place = lookup.cube(direction);
      const Number3 back = maps::cubeDirection(orientation, place.face, place.s, place.t);
      REQUIRE(dot(back - direction, back - direction) < kDouble * kDouble);
    }
  }
}

TEST_CASE("Orientation, LatlongsAreTheInverseOfEveryEnginesLookup") {
  std::mt19937 random(2);
  for (const EngineLookup& lookup : engineLookups()) {
    const maps::Orientation orientation = orientationFor(lookup);
    CAPTURE(lookup.engine);
    for (int i = 0; i < kDirections; ++i) {
      const Number3 direction = randomDirection(random);
      const LatlongPlace place = lookup.latlong(direction);
      const Number3 back = maps::latlongDirection(orientation, place.u, place.v);
      REQUIRE(dot(back - direction, back - direction) < kNearPole * kNearPole);
    }
  }
}

TEST_CASE("Orientation, ThreesLatlongIsAQuarterTurnFromWelkins") {
  // A sun at azimuth 76 degrees stands in column 13 of 64 of Welkin's latlong, and in column 29 of that for three.js.
  const double azimuth = 76.0 * det::kDegree;
  const Number3 sun(std::sin(azimuth), 0.0, -std::cos(azimuth));
  const auto column = [&](const maps::Orientation& orientation) {
    int nearest = 0;
    double most = -1.0;
    for (int i = 0; i < 64; ++i) {
      const double cosine = dot(maps::latlongDirection(orientation, (i + 0.5) / 64, 0.5), sun);
      if (cosine > most) {
        most = cosine;
        nearest = i;
      }
    }
    return nearest;
  };
  CHECK(column(maps::welkinOrientation()) == 13);
  CHECK(column(*maps::orientationOf("three")) == 29);
}

TEST_CASE("Orientation, UnknownEnginesHaveNone") {
  CHECK_FALSE(maps::orientationOf("").has_value());
  CHECK_FALSE(maps::orientationOf("Unity").has_value());
  CHECK(maps::engineNames() == "three, unity, unreal, godot, filament");
}

}  // namespace welkin::tests
