// SPDX-License-Identifier: Apache-2.0
// Maps of a sky: an engine finds the sun and every other direction by its own lookup; mips are means.
#include "maps/sky_map.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "engine_lookup.h"
#include "map_sky.h"

namespace welkin::tests {
namespace {

using det::Number3;

constexpr int kSize = 32;

maps::Orientation orientationNamed(const EngineLookup& lookup) {
  return maps::orientationOf(lookup.engine).value_or(maps::welkinOrientation());
}

const float* texelAt(const maps::Map& map, int column, int row) {
  return map.rgb.data() +
         3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(map.width) + static_cast<std::size_t>(column));
}

/// Index of the texel with the most green.
int brightest(const maps::Map& map) {
  int best = 0;
  for (int i = 0; i < map.width * map.height; ++i)
    if (texelAt(map, i, 0)[1] > texelAt(map, best, 0)[1]) best = i;
  return best;
}

}  // namespace

TEST_CASE("SkyMap, EveryEngineFindsTheSunInItsCube") {
  const MapSky sky;
  for (const EngineLookup& lookup : engineLookups()) {
    const maps::Map cube = maps::renderCube(sky.get(), sky.sample, orientationNamed(lookup), kSize);
    REQUIRE(cube.width == kSize);
    REQUIRE(cube.height == 6 * kSize);
    const CubePlace place = lookup.cube(sky.sun());
    const int column = static_cast<int>(place.s * kSize), row = place.face * kSize + static_cast<int>(place.t * kSize);
    CAPTURE(lookup.engine, brightest(cube) % kSize, brightest(cube) / kSize);
    CHECK(brightest(cube) == row * kSize + column);
  }
}

TEST_CASE("SkyMap, EveryEngineFindsTheSunInItsLatlong") {
  const MapSky sky;
  for (const EngineLookup& lookup : engineLookups()) {
    const maps::Map map = maps::renderLatlong(sky.get(), sky.sample, orientationNamed(lookup), kSize);
    REQUIRE(map.width == 2 * kSize);
    REQUIRE(map.height == kSize);
    const LatlongPlace place = lookup.latlong(sky.sun());
    const int column = static_cast<int>(place.u * 2 * kSize), row = static_cast<int>(place.v * kSize);
    CAPTURE(lookup.engine, brightest(map) % (2 * kSize), brightest(map) / (2 * kSize));
    CHECK(brightest(map) == row * 2 * kSize + column);
  }
}

TEST_CASE("SkyMap, FacesShowTheDomeWhereEnginesLook") {
  // The nearest texel is within half a texel, 1/32 of a face, in each direction: the sky changes little over it, away
  // from the sun and the horizon. A wrong face, turn or mirror is off by far more.
  constexpr double kSkyOfHalfATexel = 0.15;
  const MapSky sky;
  std::mt19937 random(3);
  for (const EngineLookup& lookup : engineLookups()) {
    const maps::Map cube = maps::renderCube(sky.get(), sky.sample, orientationNamed(lookup), kSize);
    bool seen[6] = {};
    for (int i = 0; i < 600; ++i) {
      const Number3 direction = randomDirection(random);
      if (std::abs(direction.y) < 0.15 || dot(direction, sky.sun()) > 0.9) continue;
      const CubePlace place = lookup.cube(direction);
      seen[place.face] = true;
      const float* texel =
          texelAt(cube, static_cast<int>(place.s * kSize), place.face * kSize + static_cast<int>(place.t * kSize));
      const float d[3] = {static_cast<float>(direction.x), static_cast<float>(direction.y),
                          static_cast<float>(direction.z)};
      float expected[3];
      REQUIRE(welkin_dome_radiance(sky.get(), &sky.sample, d, expected) == WELKIN_OK);
      CAPTURE(lookup.engine, place.face, place.s, place.t);
      for (int c = 0; c < 3; ++c) REQUIRE(double{texel[c]} == Approx(double{expected[c]}).epsilon(kSkyOfHalfATexel));
    }
    for (const bool face : seen) CHECK(face);
  }
}

TEST_CASE("SkyMap, TexelsAreEvaluatedAtTheirCentres") {
  // No half texel is lost: the lookup of a texel's centre gives back its column and row.
  const MapSky sky;
  for (const EngineLookup& lookup : engineLookups()) {
    const maps::Orientation orientation = orientationNamed(lookup);
    const maps::Map cube = maps::renderCube(sky.get(), sky.sample, orientation, 5);
    for (int i = 0; i < 6 * 5 * 5; ++i) {
      const int face = i / 25, row = i / 5 % 5, column = i % 5;
      const Number3 direction = maps::cubeDirection(orientation, face, (column + 0.5) / 5, (row + 0.5) / 5);
      const CubePlace place = lookup.cube(direction);
      REQUIRE(place.face == face);
      REQUIRE(place.s * 5 == Approx(column + 0.5));
      REQUIRE(place.t * 5 == Approx(row + 0.5));
      const float d[3] = {static_cast<float>(direction.x), static_cast<float>(direction.y),
                          static_cast<float>(direction.z)};
      float expected[3];
      welkin_dome_radiance(sky.get(), &sky.sample, d, expected);
      for (int c = 0; c < 3; ++c) REQUIRE(texelAt(cube, column, face * 5 + row)[c] == expected[c]);
    }
  }
}

TEST_CASE("SkyMap, MipsAreMeansOfTwoByTwo") {
  maps::Map cube{5, 30, {}};
  for (int i = 0; i < 5 * 30; ++i)
    for (int c = 0; c < 3; ++c) cube.rgb.push_back(static_cast<float>(100 * (i / 5) + 10 * (i % 5) + c));
  const maps::Map mip = maps::nextMip(cube);
  REQUIRE(mip.width == 2);
  REQUIRE(mip.height == 12);
  for (int face = 0; face < 6; ++face)
    for (int row = 0; row < 2; ++row)
      for (int column = 0; column < 2; ++column)
        for (int c = 0; c < 3; ++c)  // the mean of rows 5 face + 2 row + (0, 1) and columns 2 column + (0, 1)
          REQUIRE(texelAt(mip, column, 2 * face + row)[c] ==
                  static_cast<float>(100 * (5 * face + 2 * row) + 50 + 20 * column + 5 + c));
  CHECK(maps::faceOf(mip, 4).rgb == std::vector<float>(mip.rgb.begin() + 4 * 12, mip.rgb.begin() + 5 * 12));
}

}  // namespace welkin::tests
