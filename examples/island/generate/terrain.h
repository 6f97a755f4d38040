// SPDX-License-Identifier: Apache-2.0
// The ground: coast, heights, mesh and colours.
#pragma once

#include "generate/mesh.h"

namespace welkin::island {

inline constexpr double kHalfExtent_m = 128.0;

/// Place of the cave: the middle of its floor at the mouth, and its axis.
struct CaveSite {
  Vec3 mouth;
  double azimuth_rad = 0.0;  ///< direction of the axis, inward
};
CaveSite caveSite();

/// Distance from the coast in metres, roughly; positive on land.
double inland_m(double x, double z);

/// Height of the ground above the sea.
double height_m(double x, double z);

/// A point on the ground.
inline Vec3 onGround(double x, double z) {
  return {x, height_m(x, z), z};
}

/// Unit normal of the ground.
Vec3 groundNormal(double x, double z);

/// The ground, with a hole where the cave opens.
Shape terrain();

}  // namespace welkin::island
