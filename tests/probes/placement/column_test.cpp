// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/column.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "probes/placement/lattice.h"
#include "tests/probes/rooms.h"

namespace welkin::tests {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Blocks side by side, as a level editor leaves them: tops at multiples of 1/8 m, shared edges, all on whole metres.
geometry::Surfaces blocks(int across) {
  geometry::Surfaces s;
  const auto stone = addMaterial(s, {0.5, 0.5, 0.5});
  for (int k = 0; k < across; ++k)
    for (int i = 0; i < across; ++i)
      addQuad(s, {double(i), 0.125 * ((i * 7 + k * 3) % 5), double(k)}, {0, 0, 1}, {1, 0, 0}, stone);
  return s;
}

double blockHeight(double x, double z) {
  return 0.125 * ((static_cast<int>(std::floor(x)) * 7 + static_cast<int>(std::floor(z)) * 3) % 5);
}

}  // namespace

TEST_CASE("Column, StoreysAreSpansOfAir") {
  geometry::Surfaces s = groundOf({0.5, 0.5, 0.5});
  addBoxOutside(s, {-5, 3, -5}, {5, 3.5, 5}, 0);
  addBoxOutside(s, {-5, 6.5, -5}, {5, 7, 5}, 0);
  const geometry::Tracer tracer(s);
  const auto span = placement::spansAt(tracer, 1.037, 0.021, 10);
  REQUIRE(span.size() == 3);
  CHECK(span[0].low_y == 0.0);
  CHECK(span[0].high_y == Approx(3.0));
  CHECK(span[1].low_y == Approx(3.5));
  CHECK(span[1].high_y == Approx(6.5));
  CHECK(span[2].low_y == Approx(7.0));
  CHECK(span[2].high_y == kInfinity);
  for (const placement::Span& x : span) {
    CHECK(x.floor_normal_y == Approx(1.0));
    CHECK_FALSE(x.inside);
  }
}

TEST_CASE("Column, TheInsideOfABodyOnTheGroundIsNoAir") {
  geometry::Surfaces s = groundOf({0.5, 0.5, 0.5});
  addBoxOutside(s, {-3, 0, -3}, {3, 4, 3}, 0);   // its bottom lies in the ground
  addBoxOutside(s, {7, -1, -3}, {13, 4, 3}, 0);  // stands in it
  const geometry::Tracer tracer(s);
  for (const double x : {1.037, 10.037}) {
    const auto span = placement::spansAt(tracer, x, 0.021, 10);
    REQUIRE_FALSE(span.empty());
    CHECK(span.back().low_y == Approx(4.0));
    for (std::size_t i = 0; i + 1 < span.size(); ++i) CHECK((span[i].inside || !span[i].hasFloor()));
  }
}

TEST_CASE("Column, ASheetIsOpenOnTheSidesThatItHas") {
  geometry::Surfaces s;
  const auto one = addMaterial(s, {0.5, 0.5, 0.5});
  const auto two = addMaterial(s, {0.5, 0.5, 0.5}, true);
  addQuad(s, {-5, 2, -5}, {0, 0, 10}, {10, 0, 0}, one);
  addQuad(s, {15, 2, -5}, {0, 0, 10}, {10, 0, 0}, two);
  addQuad(s, {35, 2, -5}, {10, 0, 0}, {0, 0, 10}, one);  // looks down
  const geometry::Tracer tracer(s);
  REQUIRE(placement::spansAt(tracer, 0.037, 0.021, 5).size() == 1);
  CHECK(placement::spansAt(tracer, 0.037, 0.021, 5)[0].low_y == 2.0);
  CHECK(placement::spansAt(tracer, 20.037, 0.021, 5).size() == 2);
  REQUIRE(placement::spansAt(tracer, 40.037, 0.021, 5).size() == 1);
  CHECK(placement::spansAt(tracer, 40.037, 0.021, 5)[0].high_y == 2.0);
  CHECK_FALSE(placement::spansAt(tracer, 40.037, 0.021, 5)[0].hasFloor());
  const auto nothing = placement::spansAt(tracer, 100, 0, 5);
  REQUIRE(nothing.size() == 1);
  CHECK(nothing[0].high_y == kInfinity);
}

TEST_CASE("Column, NoLineSlipsThroughSharedEdges") {
  constexpr int kAcross = 48;
  const geometry::Surfaces s = blocks(kAcross);
  const geometry::Tracer tracer(s);
  std::size_t slips = 0;
  std::size_t lines = 0;
  for (const placement::LatticeLine& line : placement::latticeOf({0, 0}, 0.5)) {
    if (line.x > kAcross || line.z > kAcross) continue;
    ++lines;
    const auto span = placement::spansAt(tracer, line.x, line.z, 2.0);
    const bool right = span.size() == 1 && span[0].low_y == blockHeight(line.x, line.z);
    slips += right ? 0 : 1;
  }
  CHECK(lines > 9000);
  CHECK(slips == 0);
}

TEST_CASE("Lattice, EverySectorHasTheSameLines") {
  for (const double spacing : {4.0, 3.0, 8.0, 5.5}) {
    const auto home = placement::latticeOf({0, 0}, spacing);
    const auto across = static_cast<std::size_t>(std::floor((64.0 - placement::kLattice_x_m) / spacing + 0.5));
    const auto along = static_cast<std::size_t>(std::floor((64.0 - placement::kLattice_z_m) / spacing + 0.5));
    CHECK(home.size() == across * along);
    for (std::size_t i = 1; i < across; ++i) CHECK(home[i].x - home[i - 1].x == Approx(spacing));
    for (const geometry::SectorId id : {geometry::SectorId{-2, 1}, geometry::SectorId{15000, -15000}}) {
      const auto lines = placement::latticeOf(id, spacing);
      REQUIRE(lines.size() == home.size());
      for (std::size_t i = 0; i < lines.size(); ++i) {
        CHECK(geometry::sectorAt({lines[i].x, 0, lines[i].z}) == id);
        CHECK(std::abs(lines[i].x - 64.0 * id.x - home[i].x) < 1e-9);  // the rounding of a double
        CHECK(std::abs(lines[i].z - 64.0 * id.z - home[i].z) < 1e-9);
      }
    }
  }
  CHECK(placement::latticeOf({0, 0}, 4.0).size() == 256);
}

TEST_CASE("Column, OfManySurfacesEachIsFound") {
  geometry::Surfaces s;
  const auto sheet = addMaterial(s, {0.5, 0.5, 0.5}, true);
  constexpr int kSheets = 300;
  for (int i = 0; i < kSheets; ++i)
    for (const double beside_m : {0.0, 4e-4})  // two within a millimetre count as one
      addQuad(s, {-5, 0.125 * i - beside_m, -5}, {0, 0, 10}, {10, 0, 0}, sheet);
  const geometry::Tracer tracer(s);
  const auto span = placement::spansAt(tracer, 0.037, 0.021, 100);
  REQUIRE(span.size() == kSheets + 1);
  for (int i = 0; i < kSheets; ++i) {
    const placement::Span& above = span[static_cast<std::size_t>(i) + 1];
    CHECK(above.low_y == Approx(0.125 * i).margin(1e-5));  // floats at 40 m
    CHECK(above.high_y == (i + 1 < kSheets ? Approx(0.125 * (i + 1)).margin(1e-5) : Approx(kInfinity)));
    CHECK_FALSE(above.inside);
  }
}

TEST_CASE("Column, OfManyDoubtfulSpansTheHighestAreAsked") {
  for (const int floors : {64, 100, 3000}) {
    geometry::Surfaces s;
    const auto floor = addMaterial(s, {0.5, 0.5, 0.5});
    std::vector<double> height_m;
    double y = 0.0;
    for (int i = 0; i < floors; ++i) {
      addQuad(s, {-500, y, -500}, {0, 0, 1000}, {1000, 0, 0}, floor);  // its back hides the space below from above
      height_m.push_back(0.01 * (10 + i * 37 % floors));
      y += height_m.back();
    }
    const geometry::Tracer tracer(s);
    const auto span = placement::spansAt(tracer, 0.037, 0.021, y + 10.0);
    REQUIRE(span.size() == static_cast<std::size_t>(floors));
    height_m.pop_back();  // the highest floor has open air above
    std::sort(height_m.begin(), height_m.end(), std::greater<>());
    const std::size_t most = floors <= 64 ? height_m.size() : 2048 / static_cast<std::size_t>(floors);
    std::size_t asked = 0;
    for (const placement::Span& x : span) {
      if (!x.inside) continue;
      ++asked;
      CHECK(x.high_y - x.low_y > height_m[most - 1] - 0.005);  // half of the step of heights
    }
    CHECK(asked == most);
  }
}

}  // namespace welkin::tests
