// SPDX-License-Identifier: Apache-2.0
// Light of points in a level whose cells walls part, and of batches of them.
#include <welkin/level.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstring>
#include <random>

#include "format/cell_cuts.h"
#include "tests/runtime/level_points.h"

namespace welkin::tests {
namespace {

using transfer::SunTransfer;

/// Parts some cells of every sector by a plane each, of any direction, with any probes and masks on its sides.
void cutAtRandom(RandomLevel& baked, std::size_t probes) {
  std::mt19937 random(11);
  const auto below = [&](unsigned end) { return static_cast<unsigned>(random() % end); };
  for (std::size_t i = 0; i < baked.sector.size(); ++i) {
    sectors::SectorFile& s = baked.sector[i];
    s.cuts.mask = {format::kAllOpen, format::kOwnOpen, 0x00ff2ffU | format::kOwnOpen, 0x7fe0000U | format::kOwnOpen};
    for (unsigned cell = 0; cell < 4096; ++cell) {
      if (below(8) != 0) continue;
      const auto leaf = [&] {
        const unsigned probe = below(9) == 0 ? 255 : below(static_cast<unsigned>(probes));
        return static_cast<std::uint16_t>(format::kCutLeaf | below(4) << 8 | probe);
      };
      s.cuts.cell.push_back(static_cast<std::uint16_t>(cell));
      s.cuts.tree.push_back(static_cast<std::uint16_t>(s.cuts.node.size()));
      s.cuts.node.insert(s.cuts.node.end(), {static_cast<std::uint16_t>(s.cuts.plane.size()), leaf(), leaf()});
      const auto turn = [&] { return static_cast<std::int16_t>(static_cast<int>(below(65535)) - 32767); };
      const std::int16_t u = turn(), v = turn();
      const auto middle = [](unsigned at) { return (static_cast<float>(at) + 0.5F) * 4.0F; };
      const auto y = static_cast<float>(s.low_y) +
                     (static_cast<float>(cell / 16 % 16) + 0.5F) * static_cast<float>(s.cell_height_m);
      const float offset = format::aboveBy({u, v, 0.0F}, {middle(cell % 16), y, middle(cell / 256)});
      s.cuts.plane.emplace_back(u, v, offset);
    }
  }
  baked.reindex();
}

}  // namespace

TEST_CASE("PointLight, IrradianceIsTheReferencesAmongWalls") {
  constexpr double kFloats = 2e-6;  // sums of some fifty floats
  RandomLevel baked(3, 37, 10, SunTransfer::directional, false);
  cutAtRandom(baked, 37);
  OpenedLevel opened(baked);
  CHECK(differenceOf(baked, opened, 9.0) < kFloats);
}

TEST_CASE("PointLight, ABatchHasTheBitsOfItsPoints") {
  RandomLevel baked(3, 37, 10, SunTransfer::directional, false);
  cutAtRandom(baked, 37);
  OpenedLevel opened(baked);
  opened.relight(9.0);
  const std::vector<Point> points = somePoints(500);
  using Number = std::array<float, 3>;
  std::vector<Number> position, normal, batch(points.size());
  std::vector<std::uint8_t> served(points.size());
  for (const Point& p : points) {
    position.push_back({p.position[0], p.position[1], p.position[2]});
    normal.push_back({p.normal[0], p.normal[1], p.normal[2]});
  }
  using Rows = const float(*)[3];
  const auto rows = [](const std::vector<Number>& of) { return reinterpret_cast<Rows>(of.data()); };
  REQUIRE(welkin_level_irradiance(opened.level, points.size(), rows(position), rows(normal),
                                  reinterpret_cast<float(*)[3]>(batch.data()), served.data()) == WELKIN_OK);
  for (std::size_t i = 0; i < points.size(); ++i) {
    float alone[3];
    std::uint8_t is_served = 2;
    REQUIRE(welkin_level_irradiance(opened.level, 1, rows(position) + i, rows(normal) + i, &alone, &is_served) ==
            WELKIN_OK);
    CHECK(std::memcmp(alone, batch[i].data(), sizeof alone) == 0);
    CHECK(is_served == served[i]);
  }
}

}  // namespace welkin::tests
