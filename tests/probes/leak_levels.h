// SPDX-License-Identifier: Apache-2.0
// Sealed places with walls of 0.1 m on open ground, and how much of the open light filtering brings in.
#pragma once

#include <string>
#include <vector>

#include "probes/build/level_bake.h"
#include "probes/geometry/surfaces.h"

namespace welkin::tests {

using f64::Number3;

/// A point of an inner surface, or in the air.
struct LeakPoint {
  Number3 position;
  Number3 normal;
  double push_m = 1.0;
};

struct LeakLevel {
  geometry::Surfaces surfaces;
  std::vector<LeakPoint> point;
  std::vector<geometry::Box> room;  ///< from the middle of wall to wall, about a turned place too
  bool sealed = true;               ///< if false, light comes in through a door
};

/// Names of the shapes that leakLevel makes.
const std::vector<std::string>& leakShapes();

/// One of the shapes at a random place of sector 0_0, the same for the same seed.
LeakLevel leakLevel(const std::string& shape, std::uint64_t seed);

/// Shares of the open ground's light under a uniform sky.
struct Leak {
  double mean = 0.0, worst = 0.0;
  bool any = false;  ///< whether any point has light
  LeakPoint worst_at;
  std::size_t without = 0;  ///< points that no probe serves
  std::size_t cut_cells = 0, bytes = 0;
};

/// Bakes the level and looks at its points. Behind a door the leak is what is brighter than all probes of the inside
/// that the point sees. `masks` false: trees are read, but no cell counts as shut.
Leak leakOf(const LeakLevel& level, placement::Walls walls, bool masks = true);

}  // namespace welkin::tests
