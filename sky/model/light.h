// SPDX-License-Identifier: Apache-2.0
// Direction, brightness and colour of the sun and the moon over the day.
#pragma once

#include "sky/base/curve.h"

namespace welkin::model {

using det::Number3;

/// The path of a light: the daily circle of a frozen declination, or keys drawn by hand if there are any.
struct LightPath {
  double latitude_rad = 0.0;      ///< [-pi/2, pi/2]
  double declination_rad = 0.0;   ///< [-pi/2, pi/2]
  double transit_h = 12.0;        ///< clock time of the crossing of the meridian
  double north_offset_rad = 0.0;  ///< added to every azimuth
  std::vector<double> key_time_h;
  std::vector<double> key_azimuth_rad;
  std::vector<double> key_elevation_rad;  ///< [-pi/2, pi/2]

  /// Unit direction towards the light at a finite time.
  Number3 directionAt(double time_h) const;
};

/// Declination of the sun on a day and clock time of its transit, frozen at 12 h of clock time. Meeus, "Astronomical
/// Algorithms" (1998), ch. 25 (low accuracy, 0.01 degrees) and ch. 28 (equation of time), without nutation. `year` in
/// [-2000, 6000], `day_of_year` 1..366, longitude in degrees, east positive, offset in hours.
LightPath sunPathFromPlace(double latitude_deg, double longitude_deg, double utc_offset_h, int year, int day_of_year);

struct Light {
  LightPath path;
  base::Curve illuminance = base::Curve::constant(0.0);      ///< scene units, >= 0
  base::Curve colour = base::Curve::constant(Number3(1.0));  ///< only hue and saturation count; luminance > 0
  double disc_radius_rad = 0.0;                              ///< [0, pi/2]; 0: no disc

  /// RGB irradiance of a surface that faces the light: illuminance x colour / luminance(colour).
  Number3 normalIrradianceAt(double time_h) const {
    return det::normalIrradiance(colour.colourAt(time_h), illuminance.at(time_h));
  }
};

}  // namespace welkin::model
