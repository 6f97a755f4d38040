// SPDX-License-Identifier: Apache-2.0
// Directions for rays: uniform over the sphere, cosine-distributed about a normal; the same bits everywhere.
#pragma once

#include <cmath>

#include "probes/surfaces.h"

namespace welkin::probes {

/// A vector of length > 0 over its length.
inline Number3 unit(const Number3& v) {
  return v * (1.0 / std::sqrt(dot(v, v)));
}

/// Of two numbers in [0, 1): uniform over the sphere (Archimedes: y is uniform).
Number3 sphereDirection(double s, double t);

/// Of two numbers in [0, 1): density cos / pi about a unit normal, and never in its plane.
Number3 cosineDirection(const Number3& normal, double s, double t);

}  // namespace welkin::probes
