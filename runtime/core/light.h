// SPDX-License-Identifier: Apache-2.0
// The sun or the moon of an opened file: direction, brightness and colour at any hour.
#pragma once

#include <welkin/welkin.h>

#include <span>

#include "core/curve.h"

namespace welkin::core {

/// Direction of a light over the day. Borrows the file's keys if the path was drawn by hand.
class LightPath {
 public:
  LightPath() = default;
  explicit LightPath(const format::LightPath& path);

  /// Unit direction towards the light at an hour in [0, 24).
  f64::Number3 directionAt(double time_h) const;

 private:
  std::span<const double> time_h_, azimuth_rad_, elevation_rad_;  ///< keys; empty: the light follows the circle
  f64::DailyCircle circle_{};
  double transit_h_ = 0.0;
};

class Light {
 public:
  Light() = default;
  explicit Light(const format::Light& light);

  struct Instant {
    f64::Number3 direction;          ///< unit, towards the light
    f64::Number3 normal_irradiance;  ///< RGB irradiance of a surface that faces the light
  };
  /// The light at an hour in [0, 24). Returns it in double, and writes it to `out` in the floats of the C interface.
  Instant at(double time_h, WelkinLight& out) const;

 private:
  LightPath path_;
  Curve illuminance_, colour_;
  double disc_radius_rad_ = 0.0;
};

}  // namespace welkin::core
