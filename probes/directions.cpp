// SPDX-License-Identifier: Apache-2.0
#include "probes/directions.h"

#include <algorithm>

#include "sh/deterministic.h"

namespace welkin::probes {

Number3 sphereDirection(double s, double t) {
  const double y = 1.0 - 2.0 * s;
  const double across = std::sqrt(std::max((1.0 - y) * (1.0 + y), 0.0));
  const double azimuth = det::kTwoPi * t;
  return {across * det::sin(azimuth), y, across * det::cos(azimuth)};
}

Number3 cosineDirection(const Number3& normal, double s, double t) {
  // Two tangents without a branch near the pole (Duff et al., "Building an Orthonormal Basis, Revisited", 2017).
  const double sign = std::copysign(1.0, normal.z);
  const double a = -1.0 / (sign + normal.z);
  const double b = normal.x * normal.y * a;
  const Number3 x(1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x);
  const Number3 y(b, sign + normal.y * normal.y * a, -normal.y);
  const double radius = std::sqrt(s);
  const double azimuth = det::kTwoPi * t;
  return x * (radius * det::cos(azimuth)) + y * (radius * det::sin(azimuth)) + normal * std::sqrt(1.0 - s);
}

}  // namespace welkin::probes
