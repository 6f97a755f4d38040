// SPDX-License-Identifier: Apache-2.0
// A place without symmetry for the fit: an oblique wall, a shed and a closed box on ground.
#pragma once

#include "probes/build/level_bake.h"
#include "tests/probes/rooms.h"
#include "tests/probes/skies.h"

namespace welkin::tests {

/// Inside of the closed box, walls of 0.2 m.
inline constexpr double kBoxLow = 40.0, kBoxHigh = 52.0;

inline geometry::Surfaces fitYard() {
  geometry::Surfaces s = groundOf(Number3(0.3, 0.4, 0.2), 90.0);
  addQuad(s, {20.3, 0, 15.1}, {7.7, 0, 3.1}, {0, 5, 0}, addMaterial(s, Number3(0.8, 0.2, 0.1), true));
  addQuad(s, {8.0, 2.8, 30.0}, {9, 0.6, 1}, {-1, 0, 8}, addMaterial(s, Number3(0.5, 0.5, 0.6), true));
  const std::uint32_t grey = addMaterial(s, Number3(0.5));
  addBoxInside(s, {kBoxLow, 0.0, kBoxLow}, {kBoxHigh, 4.0, kBoxHigh}, grey);
  addBoxOutside(s, {kBoxLow - 0.2, 0.0, kBoxLow - 0.2}, {kBoxHigh + 0.2, 4.2, kBoxHigh + 0.2}, grey);
  return s;
}

inline build::BakeSection fitSection(build::Fit fit) {
  build::BakeSection section;
  section.transfer.rays = 1024;
  section.transfer.reach_m = 48.0;
  section.transfer.fit = fit;
  return section;
}

inline model::Sky fitSky() {
  model::Sky sky = clearSky(1.1, 0.8);
  sky.ground_albedo = Number3(0.2, 0.1, 0.3);
  return sky;
}

}  // namespace welkin::tests
