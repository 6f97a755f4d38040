// SPDX-License-Identifier: Apache-2.0
// Trees that part a cell, and the lookup of the eight cells about a point that honours them.
#include "format/cell_cuts.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "format/cut_lookup.h"

namespace welkin::format::tests {
namespace {

constexpr std::uint16_t leafNode(std::size_t mask, std::uint8_t probe) {
  return static_cast<std::uint16_t>(kCutLeaf | mask << 8 | probe);
}

/// A sector whose cells all name probe 0, with a wall at x = 22, inside of cells with x index 5, and what is beyond it,
/// probe 1, from there to 24. The cells from 24 on are of probe 2, and the wall at x = 40 runs where cells meet.
struct WalledSector {
  std::vector<std::uint8_t> grid = std::vector<std::uint8_t>(4096, 0);
  std::vector<std::uint16_t> cell, tree, node;
  std::vector<CutPlane> plane = {{32767, 0, 22.0F}};
  std::vector<std::uint32_t> mask = {kAllOpen};
  GridView view;

  WalledSector() {
    const auto shut = [](int dx) {
      std::uint32_t open = kAllOpen;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dz = -1; dz <= 1; ++dz) open &= ~openBit(dx, dy, dz);
      return open;
    };
    mask.push_back(shut(1));
    mask.push_back(shut(-1));
    node = {0, leafNode(1, 0), leafNode(2, 1), leafNode(1, 2), leafNode(2, 3)};
    for (int i = 0; i < 4096; ++i) {
      const int x = i % 16;
      grid[static_cast<std::size_t>(i)] = x < 6 ? 0 : x < 10 ? 2 : 3;
      if (x != 5 && x != 9 && x != 10) continue;
      cell.push_back(static_cast<std::uint16_t>(i));
      tree.push_back(x == 5 ? 0 : x == 9 ? 3 : 4);
    }
    view = {grid, 0.0, 4.0, {cell, tree, node, plane, mask}};
  }

  const GridView* operator()(int x, int z) const { return x == 0 && z == 0 ? &view : nullptr; }
};

/// The share of each probe at a place.
std::array<double, 4> sharesAt(const InWorld& p, const WalledSector& sector) {
  const EightProbes found = probesAbout(p, sector);
  std::array<double, 4> share{};
  double sum = 0.0;
  for (std::size_t i = 0; i < found.count; ++i) sum += found.probe[i].weight;
  for (std::size_t i = 0; i < found.count; ++i) share[found.probe[i].probe] += found.probe[i].weight / sum;
  return share;
}

}  // namespace

TEST_CASE("CellCuts, NormalsOfAnOctahedralMap") {
  CHECK(normalOf({0, 0, 0.0F}) == FromCorner{0, 1, 0});
  CHECK(normalOf({32767, 0, 0.0F}) == FromCorner{1, 0, 0});
  CHECK(normalOf({0, -32767, 0.0F}) == FromCorner{0, 0, -1});
  CHECK(normalOf({32767, 32767, 0.0F}) == FromCorner{0, -1, 0});
  CHECK(normalOf({-32767, 32767, 0.0F}) == FromCorner{0, -1, 0});
  for (int u = -32767; u <= 32767; u += 1234)
    for (int v = -32767; v <= 32767; v += 1234) {
      const FromCorner n = normalOf({static_cast<std::int16_t>(u), static_cast<std::int16_t>(v), 0.0F});
      CHECK(std::abs(std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2]) - 1.0F) < 1e-6F);
      CHECK(n[0] * static_cast<float>(u) >= 0.0F);
    }
}

TEST_CASE("CellCuts, ATreeFindsTheLeafOfEveryPoint") {
  // Three planes: x = 1; below it y = 2, above it z = 3 and then a leaf on each side.
  const std::vector<CutPlane> plane = {{32767, 0, 1.0F}, {0, 0, 2.0F}, {0, 32767, 3.0F}};
  const std::vector<std::uint32_t> mask = {kAllOpen, kOwnOpen};
  const std::vector<std::uint16_t> node = {
      0, 1, leafNode(0, 10), leafNode(1, 11), 2, leafNode(0, 12), leafNode(1, 255)};
  const std::vector<std::uint16_t> cell = {5}, tree = {0};
  const CellCuts cuts{cell, tree, node, plane, mask};
  CHECK(afterTree(node, 0) == 7);
  CHECK(afterTree(node, 1) == 4);
  const auto at = [&](float x, float y, float z) { return leafOfCell(cuts, 5, 99, {x, y, z}); };
  CHECK(at(0.5F, 1.5F, 9.0F) == CutLeaf{10, kAllOpen});
  CHECK(at(0.5F, 2.5F, 9.0F) == CutLeaf{11, kOwnOpen});
  CHECK(at(1.5F, 2.5F, 2.5F) == CutLeaf{12, kAllOpen});
  CHECK(at(1.5F, 2.5F, 3.5F) == CutLeaf{255, kOwnOpen});
  CHECK(at(1.0F, 2.0F, 3.5F) == CutLeaf{10, kAllOpen});  // a point of a plane is below it
  CHECK(leafOfCell(cuts, 4, 99, {0, 0, 0}) == CutLeaf{99, kAllOpen});
  CHECK(leafOfCell(cuts, 6, 99, {0, 0, 0}) == CutLeaf{99, kAllOpen});
  CHECK(cutWay(cuts, 5, 99, {0.5F, 1.5F, 0.0F}, {0, 1, 0}).way_m == 0.5F);
  CHECK(cutWay(cuts, 5, 99, {0.5F, 1.5F, 0.0F}, {0, -1, 0}).way_m == std::numeric_limits<float>::infinity());
  CHECK(cutWay(cuts, 5, 99, {0.75F, 1.0F, 0.0F}, {0.6F, 0.8F, 0}).way_m == Approx(0.25 / 0.6));
  CHECK(cutWay(cuts, 4, 99, {0.5F, 1.5F, 0.0F}, {0, 1, 0}).way_m == std::numeric_limits<float>::infinity());
}

TEST_CASE("CutLookup, NoProbeOfTheOtherSideCounts") {
  const WalledSector sector;
  for (double x = 8.0; x < 56.0; x += 0.0625) {
    const std::array<double, 4> share = sharesAt({x, 9.3, 30.1}, sector);
    INFO(x);
    CHECK(share[0] == Approx(x <= 22.0 ? 1.0 : 0.0).epsilon(1e-12));
    CHECK(share[3] == Approx(x < 40.0 ? 0.0 : 1.0).epsilon(1e-12));
    CHECK(share[1] + share[2] == Approx(x > 22.0 && x < 40.0 ? 1.0 : 0.0).margin(1e-12));
    if (x > 22.0 && x < 26.0) CHECK(share[1] == Approx(x < 24 ? 1.0 - (x - 22) / 4 : (26 - x) / 4));
  }
}

TEST_CASE("CutLookup, ContinuousAwayFromWalls") {
  const WalledSector sector;
  constexpr double kStep_m = 1e-3;
  constexpr double kSlope = 0.5;  // of a share over a metre: 1/4 for each axis of the way, and rounding
  const auto side = [](double v) { return v <= 22.0 ? 0 : v < 40.0 ? 1 : 2; };
  for (double x = 16.0003; x < 44.0; x += kStep_m) {  // never beside 22 by less than a float
    if (side(x) != side(x + kStep_m)) continue;
    const auto here = sharesAt({x, 9.3 + 0.01 * x, 30.1}, sector);
    const auto there = sharesAt({x + kStep_m, 9.3 + 0.01 * (x + kStep_m), 30.1}, sector);
    for (std::size_t i = 0; i < 4; ++i) CHECK(std::abs(there[i] - here[i]) <= kSlope * kStep_m);
  }
}

TEST_CASE("CutLookup, APushEndsHalfOfTheWayToAWall") {
  const WalledSector sector;
  const auto pushed = [&](double x, double direction) {
    return pushedPlace({x, 9.3, 30.1}, {direction, 0, 0}, 1.0, sector)[0];
  };
  CHECK(pushed(10.0, 1.0) == Approx(11.0));
  CHECK(pushed(21.5, 1.0) == Approx(21.75));
  CHECK(pushed(22.0, -1.0) == Approx(21.0));
  CHECK(pushed(22.0, 1.0) == Approx(23.0));  // a surface in the plane itself is on the side that it looks at
  CHECK(pushed(22.8, -1.0) == Approx(22.4));
  CHECK(pushed(19.9, 1.0) == Approx(20.9));
  CHECK(pushed(39.0, 1.0) == Approx(39.5));  // a shut face
  CHECK(pushed(40.5, -1.0) == Approx(40.25));
  CHECK(pushed(63.5, 1.0) == Approx(64.5));  // no sector there
  CHECK(pushedPlace({21.99, 9.3, 30.1}, {1, 0, 0}, 0.0, sector)[0] == 21.99);
  for (double x = 19.0; x < 21.97; x += 0.01) {  // continuous, and never across
    CHECK(pushed(x, 1.0) < 22.0);
    CHECK(pushed(x + 0.01, 1.0) - pushed(x, 1.0) == Approx(x < 19.995 ? 0.01 : 0.005).margin(0.0051));
  }
}

}  // namespace welkin::format::tests
