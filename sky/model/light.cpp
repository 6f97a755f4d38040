// SPDX-License-Identifier: Apache-2.0
#include "sky/model/light.h"

#include <cmath>

namespace welkin::model {
namespace {
/// Days from J2000.0 (1 January 2000, 12 h UT) to 12 h UT of a day in the proleptic Gregorian calendar.
double daysSinceJ2000(int year, int day_of_year) {
  const auto daysBefore = [](long y) {
    const long p = y - 1;
    const auto floorDivide = [](long a, long b) { return a / b - (a % b < 0 ? 1 : 0); };
    return 365 * p + floorDivide(p, 4) - floorDivide(p, 100) + floorDivide(p, 400);
  };
  return static_cast<double>(daysBefore(year) - daysBefore(2000) + day_of_year - 1);
}

}  // namespace

Number3 LightPath::directionAt(double time_h) const {
  if (key_time_h.empty())
    return det::celestialDirection(det::kTwoPi * (format::wrapTime(time_h) - transit_h) / 24.0, declination_rad,
                                   latitude_rad, north_offset_rad);
  const format::SkyAngles angles = format::interpolatePath(key_time_h, key_azimuth_rad, key_elevation_rad, time_h);
  return det::directionOf(angles.azimuth_rad, angles.elevation_rad);
}

LightPath sunPathFromPlace(double latitude_deg, double longitude_deg, double utc_offset_h, int year, int day_of_year) {
  // 12 h of clock time is 12 h UT minus the offset. Delta T (about a minute) moves the sun by less than 0.001 degrees.
  const double t = (daysSinceJ2000(year, day_of_year) - utc_offset_h / 24.0) / 36525.0;
  const double mean_longitude = (280.46646 + 36000.76983 * t + 0.0003032 * t * t) * det::kDegree;
  const double anomaly = (357.52911 + 35999.05029 * t - 0.0001537 * t * t) * det::kDegree;
  const double eccentricity = 0.016708634 - 0.000042037 * t;
  const double centre = ((1.914602 - 0.004817 * t) * det::sin(anomaly) +
                         (0.019993 - 0.000101 * t) * det::sin(2 * anomaly) + 0.000289 * det::sin(3 * anomaly)) *
                        det::kDegree;
  const double longitude = mean_longitude + centre;
  const double obliquity = (23.439291 - 0.0130042 * t) * det::kDegree;
  const double sine = det::sin(obliquity) * det::sin(longitude);

  // Smart's series for the equation of time (Meeus 28.3), in radians of hour angle.
  const double y_root = det::sin(obliquity / 2) / det::cos(obliquity / 2);
  const double y = y_root * y_root;
  const double equation_of_time = y * det::sin(2 * mean_longitude) - 2 * eccentricity * det::sin(anomaly) +
                                  4 * eccentricity * y * det::sin(anomaly) * det::cos(2 * mean_longitude) -
                                  0.5 * y * y * det::sin(4 * mean_longitude) -
                                  1.25 * eccentricity * eccentricity * det::sin(2 * anomaly);
  LightPath path;
  path.latitude_rad = latitude_deg * det::kDegree;
  path.declination_rad = det::atan(sine, std::sqrt(1.0 - sine * sine));
  path.transit_h = 12.0 + utc_offset_h - longitude_deg / 15.0 - equation_of_time * 24.0 / det::kTwoPi;
  return path;
}

}  // namespace welkin::model
