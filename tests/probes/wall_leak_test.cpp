// SPDX-License-Identifier: Apache-2.0
// Sealed rooms with walls thinner than a cell. Their probes are dark, but where walls are ignored, filtering between
// cells lights their surfaces; a [[room]] around them ends that. `-s` prints the amounts.
#include <algorithm>
#include <catch2/catch.hpp>

#include "probes/build/level_bake.h"
#include "probes/geometry/random.h"
#include "probes/sectors/level_light.h"
#include "rooms.h"
#include "skies.h"

namespace welkin::tests {
namespace {

constexpr double kWall_m = 0.1;

struct Hall {
  const char* name;
  geometry::Box inside;
};

/// Ground with the hall on it.
geometry::Surfaces levelOf(const Hall& hall) {
  geometry::Surfaces s = groundOf(Number3(0.5), 200.0);
  const Number3 wall(kWall_m);
  addBoxOutside(s, hall.inside.low - wall, hall.inside.high + wall, 0);
  addBoxInside(s, hall.inside.low, hall.inside.high, 0);
  return s;
}

struct WallLeak {
  double mean = 0.0, worst = 0.0;
  bool any = false;  ///< whether any surface has light
};

/// Irradiance of the hall's inner walls under a uniform sky, over that of open ground.
WallLeak wallLeakOf(const Hall& hall, bool as_room) {
  build::BakeSection section;
  section.transfer.rays = 64;
  section.transfer.bounces = 0;
  section.transfer.sun = transfer::SunTransfer::none;
  section.probes.walls = placement::Walls::ignore;
  if (as_room) section.probes.room = {hall.inside};
  const model::Sky sky = uniformSky(1.0);
  const build::LevelBake level(levelOf(hall), section, sky, std::nullopt);
  const std::vector<sectors::SectorFile> sectors = {level.bake({0, 0}, {})};
  const sectors::LevelLight light(sectors, sky, 12.0);
  const Number3 size = hall.inside.high - hall.inside.low;
  geometry::Random random(3);
  WallLeak leak;
  constexpr int kPoints = 4000;
  for (int i = 0; i < kPoints; ++i) {
    const int side = i % 4;  // one of the four walls
    const double along = random.unit();
    const double up = random.unit();
    const bool is_x = side < 2;
    const double across = side % 2 == 0 ? 0.0 : 1.0;
    const Number3 p =
        hall.inside.low + Number3(size.x * (is_x ? across : along), size.y * up, size.z * (is_x ? along : across));
    const double towards = side % 2 == 0 ? 1.0 : -1.0;
    const Number3 normal(is_x ? towards : 0.0, 0.0, is_x ? 0.0 : towards);
    const auto found = light.at(p, normal);
    const double share = found ? 2.0 * found->sky.y / det::kPi : 0.0;  // an open wall sees half of the sky
    leak.mean += share / kPoints;
    leak.worst = std::max(leak.worst, share);
    leak.any = leak.any || (found && !(found->sky == Number3(0.0)));
  }
  return leak;
}

const Hall kHalls[] = {{"20 x 20 m, walls where cells meet", {{20, 0.1, 20}, {40, 5, 40}}},
                       {"29 x 29 m, off the cells' edges", {{17.3, 0.05, 17.3}, {46.6, 3, 46.6}}},
                       {"2.3 x 2.3 m", {{20, 0.1, 20}, {22.3, 2.5, 22.3}}}};

}  // namespace

TEST_CASE("WallLeak, ARoomEndsWhatFilteringLetsThroughThinWalls") {
  for (const Hall& hall : kHalls) {
    const WallLeak leak = wallLeakOf(hall, false);
    INFO(hall.name << ": mean " << leak.mean << ", worst " << leak.worst);
    CHECK(leak.worst > 0.2);  // what `walls = "ignore"` lets through, see docs/probes.md
    const WallLeak room = wallLeakOf(hall, true);
    CHECK_FALSE(room.any);
  }
}

TEST_CASE("WallLeak, ProbesOfSealedHallsAreUnlit") {
  for (const Hall& hall : kHalls) {
    for (const bool has_lamp : {false, true}) {
      geometry::Surfaces s = levelOf(hall);
      if (has_lamp) {
        const auto glow = addMaterial(s, Number3(0.0), false, Number3(1.0));
        const Number3 size = hall.inside.high - hall.inside.low;
        addQuad(s, hall.inside.low + Number3(0.0, 0.95 * size.y, 0.0), {size.x, 0, 0}, {0, 0, size.z}, glow);
      }
      const build::LevelBake level(s, build::BakeSection{}, uniformSky(1.0), std::nullopt);
      const sectors::SectorFile file = level.bake({0, 0}, {});
      const auto places = transfer::decodedProbes(file.probes, file.id).position;
      const auto inside = static_cast<std::size_t>(std::count_if(
          places.begin(), places.end(), [&](const Number3& p) { return geometry::contains(hall.inside, p); }));
      INFO(hall.name);
      CHECK(inside > 0);
      CHECK(file.unlit == (has_lamp ? 0 : inside));
    }
  }
}

}  // namespace welkin::tests
