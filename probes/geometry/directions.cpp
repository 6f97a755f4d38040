// SPDX-License-Identifier: Apache-2.0
#include "probes/geometry/directions.h"

#include <cmath>

#include "sh/deterministic.h"

namespace welkin::geometry {

Number3 sphereDirection(double s, double t) {
  const double y = 1.0 - 2.0 * s;
  const double across = det::sineFromCosine(y);
  const double azimuth = det::kTwoPi * t;
  return {across * det::sin(azimuth), y, across * det::cos(azimuth)};
}

Number3 cosineDirection(const Number3& normal, double s, double t) {
  const double radius = std::sqrt(s);
  const double azimuth = det::kTwoPi * t;
  return inFrameOf(normal, radius * det::cos(azimuth), radius * det::sin(azimuth), std::sqrt(1.0 - s));
}

}  // namespace welkin::geometry
