// SPDX-License-Identifier: Apache-2.0
// Ray directions, uniform over the sphere or cosine-distributed about a normal, with the same bits everywhere.
#pragma once

#include <cmath>

#include "probes/geometry/surfaces.h"

namespace welkin::geometry {

using f64::Number3;

/// A vector of length > 0, normalised.
inline Number3 unit(const Number3& v) {
  return v * (1.0 / std::sqrt(dot(v, v)));
}

/// Maps two numbers in [0, 1) to a direction uniform over the sphere (Archimedes: y is uniform).
Number3 sphereDirection(double s, double t);

/// The vector (x, y, z) of a frame whose third axis is a unit normal.
inline Number3 inFrameOf(const Number3& normal, double x, double y, double z) {
  // Two tangents without a branch near the pole (Duff et al., "Building an Orthonormal Basis, Revisited", 2017).
  const double sign = std::copysign(1.0, normal.z);
  const double a = -1.0 / (sign + normal.z);
  const double b = normal.x * normal.y * a;
  const Number3 across(1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x);
  const Number3 along(b, sign + normal.y * normal.y * a, -normal.y);
  return across * x + along * y + normal * z;
}

/// Maps two numbers in [0, 1) to a direction of density cos / pi about a unit normal, never in its plane.
Number3 cosineDirection(const Number3& normal, double s, double t);

}  // namespace welkin::geometry
