// SPDX-License-Identifier: Apache-2.0
#include "sensitivity.h"

#include <algorithm>
#include <cmath>

namespace welkin::stress {
namespace {

using det::Number3;
using model::LuminanceModel;

/// |f'| / f. |f'| is |a b| exp(b / y) / y^2 and has its maximum, 4 exp(-2) |a / b|, at y = |b| / 2.
double ofGradation(const LuminanceModel& m, double y) {
  const double steepest = std::abs(m.a) * 4.0 * std::exp(-2.0) / -m.b;
  const double here = y > 2.0 * -m.b ? std::abs(m.a) * (-m.b / y) * std::exp(m.b / y) / y : steepest;
  return m.a == 0.0 ? std::abs(m.k) : (1.1 * here + std::abs(m.k)) / det::gradation(m, y);
}

/// |g'| / g.
double ofIndicatrix(const LuminanceModel& m, double angle_rad) {
  return (std::abs(m.c * m.d) * std::exp(m.d * angle_rad) + std::abs(m.e)) / det::indicatrix(m, angle_rad);
}

/// Change of a chromaticity with one component of a texel: (c + y) / y^2, for c up to y / 0.0722.
double ofColour(const model::SkyInstant& instant, const Number3& direction) {
  double low = instant.sunColumn().row[0].x;
  double high = low;
  for (const auto* column : {&instant.sunColumn(), &instant.antiColumn()})
    for (const Number3& c : column->row) {
      low = std::min({low, c.x, c.y, c.z});
      high = std::max({high, c.x, c.y, c.z});
    }
  const double elevation = det::elevationOf(direction);
  const double y = det::luminanceOf(mix(instant.antiColumn().at(elevation), instant.sunColumn().at(elevation),
                                        det::azimuthWeight(direction, instant.sunDirection())));
  return 30.0 * (high - low) / std::max(y, model::kGradientDelta);
}

}  // namespace

double sensitivityAt(const model::SkyInstant& instant, const Number3& direction) {
  const LuminanceModel& m = instant.sky().luminance;
  const Number3& sun = instant.sunDirection();
  const double rows = static_cast<double>(instant.sunColumn().row.size() + instant.antiColumn().row.size());
  const double norm = instant.sky().normalise_to_sun ? ofGradation(m, std::max(sun.y, 0.0))
                                                     : ofIndicatrix(m, det::angleBetween(sun, {0.0, 1.0, 0.0}));
  return ofGradation(m, direction.y) + ofIndicatrix(m, det::angleBetween(direction, sun)) + norm +
         ofColour(instant, direction) * (1.0 / det::kAzimuthFade + rows);
}

}  // namespace welkin::stress
