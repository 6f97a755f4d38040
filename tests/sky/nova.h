// SPDX-License-Identifier: Apache-2.0
// The sun and the moon by libnova (VSOP87, ELP 2000-82B), as the reference for the almanac.
#pragma once

#include "sky/model/light.h"

namespace welkin::tests {

/// Mean equatorial coordinates of date.
struct Equatorial {
  double right_ascension_deg;
  double declination_deg;
};

/// Julian day of an hour of UT, any finite number, on a day of the proleptic Gregorian calendar. Day 366 of a year of
/// 365 days is the first day of the next year.
double julianDayOf(int year, int day_of_year, double ut_h);

/// The sun with aberration, the moon with light time. Both are geocentric. Nutation is left out, which tilts the
/// equator by at most 9.2 seconds of arc, and so is parallax (about 1 degree for the moon). The moon's series is cut at
/// 0.0005 degrees.
Equatorial novaSun(double julian_day_ut);
Equatorial novaMoon(double julian_day_ut);

/// Hour angle in (-180, 180], west of the meridian positive. The longitude is positive east.
double hourAngleOf_deg(const Equatorial& place, double julian_day_ut, double longitude_deg);

/// Unit direction in world axes, from libnova's horizontal coordinates, without refraction.
det::Number3 novaDirectionOf(const Equatorial& place, double julian_day_ut, double latitude_deg, double longitude_deg);

/// Dynamical time minus UT, in seconds.
double deltaT_s(double julian_day_ut);

/// Ecliptic longitude of mean equatorial coordinates of date, in [0, 360).
double eclipticLongitudeOf_deg(const Equatorial& place, double julian_day_ut);

}  // namespace welkin::tests
