// SPDX-License-Identifier: Apache-2.0
#include "core/light.h"

#include <algorithm>
#include <cmath>

#include "core/floats.h"

namespace welkin::core {

using f64::Number3;

LightPath::LightPath(const format::LightPath& path)
    : time_h_(format::spanOf(path.key_time_h())),
      azimuth_rad_(format::spanOf(path.key_azimuth_rad())),
      elevation_rad_(format::spanOf(path.key_elevation_rad())),
      circle_(f64::dailyCircle(path.declination_rad(), path.latitude_rad(), path.north_offset_rad())),
      transit_h_(path.transit_h()) {}

Number3 LightPath::directionAt(double time_h) const {
  if (time_h_.empty()) return f64::directionOnCircle(circle_, f64::kTwoPi * (time_h - transit_h_) / 24.0);
  const format::SkyAngles angles = format::interpolatePath(time_h_, azimuth_rad_, elevation_rad_, time_h);
  return f64::directionOf(angles.azimuth_rad, angles.elevation_rad);
}

namespace {

/// Share of a disc's area above the horizon, by the area of a circular segment. A light without a disc has the share of
/// a disc with a radius of a quarter of a degree.
double visibleShare(const Number3& direction, double disc_radius_rad) {
  constexpr double kQuarterDegree = 0.25 * f64::kPi / 180.0;
  const double radius = disc_radius_rad > 0.0 ? disc_radius_rad : kQuarterDegree;
  if (std::abs(direction.y) > radius) return direction.y > 0.0 ? 1.0 : 0.0;  // an arc is longer than its sine
  const double x = std::clamp(f64::elevationOf(direction) / radius, -1.0, 1.0);
  return std::clamp(0.5 + (std::asin(x) + x * std::sqrt(1.0 - x * x)) / f64::kPi, 0.0, 1.0);  // rounding
}

}  // namespace

Light::Light(const format::Light& light)
    : path_(*light.path()),
      illuminance_(*light.illuminance()),
      colour_(*light.colour()),
      disc_radius_rad_(light.disc_radius_rad()) {}

Light::Instant Light::at(double time_h, WelkinLight& out) const {
  const Number3 direction = path_.directionAt(time_h);
  const Number3 colour = colour_.colourAt(time_h);
  const double illuminance = illuminance_.at(time_h);
  const Number3 normal_irradiance = f64::normalIrradiance(colour, illuminance);
  store(direction, out.direction);
  out.illuminance = toFloat(illuminance);
  store(colour, out.colour);
  store(normal_irradiance, out.normal_irradiance);
  out.disc_radius_rad = toFloat(disc_radius_rad_);
  out.visible = toFloat(visibleShare(direction, disc_radius_rad_));
  return {direction, normal_irradiance};
}

}  // namespace welkin::core
