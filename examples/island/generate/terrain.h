// SPDX-License-Identifier: Apache-2.0
// The ground: where the coast runs, how high the land is, and its mesh and colours.
#pragma once

#include "generate/mesh.h"

namespace welkin::island {

inline constexpr double kHalfExtent_m = 128.0;

/// Where the cave lies: its floor's middle at the mouth, and its axis.
struct CaveSite {
  Vec3 mouth;
  double azimuth_rad = 0.0;  ///< of the way in
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
