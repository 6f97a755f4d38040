// SPDX-License-Identifier: Apache-2.0
#include "wall_level.h"

#include "tests/probes/skies.h"

namespace welkin::tests {

RandomLevel bakedLevel(const geometry::Surfaces& surfaces, std::vector<geometry::SectorId> sectors, int bounces,
                       const placement::PlacementSettings& probes) {
  build::BakeSection section;
  section.probes = probes;
  section.transfer.rays = 64;
  section.transfer.bounces = bounces;
  if (bounces > 0) section.transfer.fit = build::Fit::none;
  section.transfer.sun = transfer::SunTransfer::none;
  const build::LevelBake bake(surfaces, section, uniformSky(1.0), std::nullopt);
  if (sectors.empty()) sectors = bake.sectors();
  RandomLevel level(1, 8, 0, transfer::SunTransfer::none, false);
  level.sector.clear();
  for (const geometry::SectorId& id : sectors) level.sector.push_back(bake.bake(id, {}));
  level.reindex();
  return level;
}

placement::PlacementSettings roomsOnly(const LeakLevel& level) {
  placement::PlacementSettings settings;
  settings.walls = placement::Walls::ignore;
  settings.room = level.room;
  return settings;
}

void move(LeakLevel& level, const Number3& by) {
  for (auto& p : level.surfaces.position)
    for (int a = 0; a < 3; ++a) p[static_cast<std::size_t>(a)] += by[a];
  for (LeakPoint& p : level.point) p.position += by;
  for (geometry::Box& box : level.room) box = {box.low + by, box.high + by};
}

}  // namespace welkin::tests
