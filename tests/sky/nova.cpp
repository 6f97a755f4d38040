// SPDX-License-Identifier: Apache-2.0
#include "nova.h"

#include <libnova/libnova.h>

#include <chrono>
#include <cmath>

#include "degree.h"

namespace welkin::tests {
namespace {

constexpr double kMoonPrecision =
    1e-6;  // Precision of ln_get_lunar_ecl_coords: a thirtieth of the time for 0.0004 degrees.

/// libnova 0.16 gives the sun and the moon on the ecliptic of J2000, in spite of its headers: 0.1 degrees off in 1992.
ln_equ_posn equatorOfJ2000(double longitude_deg, double latitude_deg) {
  constexpr double kObliquity = 23.4392911 * kDegree;  // Meeus (1998), 22.2
  const double l = longitude_deg * kDegree;
  const double b = latitude_deg * kDegree;
  const double y = std::cos(b) * std::sin(l) * std::cos(kObliquity) - std::sin(b) * std::sin(kObliquity);
  const double z = std::cos(b) * std::sin(l) * std::sin(kObliquity) + std::sin(b) * std::cos(kObliquity);
  return {ln_range_degrees(std::atan2(y, std::cos(b) * std::cos(l)) / kDegree), std::asin(z) / kDegree};
}

}  // namespace

double julianDayOf(int year, int day_of_year, double ut_h) {
  using namespace std::chrono;
  const sys_days day = sys_days{std::chrono::year{year} / January / 1} + days{day_of_year - 1};
  if (year < 1583) return 2440587.5 + static_cast<double>(day.time_since_epoch().count()) + ut_h / 24.0;
  const year_month_day date{day};
  ln_date midnight{static_cast<int>(date.year()),
                   static_cast<int>(static_cast<unsigned>(date.month())),
                   static_cast<int>(static_cast<unsigned>(date.day())),
                   0,
                   0,
                   0.0};
  return ln_get_julian_day(&midnight) + ut_h / 24.0;
}

Equatorial novaSun(double julian_day_ut) {
  const double jde = ln_get_jde(julian_day_ut);
  ln_helio_posn ecliptic;
  ln_get_solar_geom_coords(jde, &ecliptic);
  ln_equ_posn mean = equatorOfJ2000(ecliptic.L, ecliptic.B);
  ln_equ_posn none{0.0, 0.0};  // proper motion
  ln_equ_posn place;
  ln_get_apparent_posn(&mean, &none, jde, &place);  // aberration and precession
  return {place.ra, place.dec};
}

Equatorial novaMoon(double julian_day_ut) {
  const double jde = ln_get_jde(julian_day_ut);
  ln_lnlat_posn ecliptic;
  ln_get_lunar_ecl_coords(jde, &ecliptic, kMoonPrecision);
  ln_equ_posn mean = equatorOfJ2000(ecliptic.lng, ecliptic.lat);
  ln_equ_posn place;
  ln_get_equ_prec(&mean, jde, &place);
  return {place.ra, place.dec};
}

double hourAngleOf_deg(const Equatorial& place, double julian_day_ut, double longitude_deg) {
  return std::remainder(15.0 * ln_get_mean_sidereal_time(julian_day_ut) + longitude_deg - place.right_ascension_deg,
                        360.0);
}

det::Number3 novaDirectionOf(const Equatorial& place, double julian_day_ut, double latitude_deg, double longitude_deg) {
  ln_equ_posn object{place.right_ascension_deg, place.declination_deg};
  ln_lnlat_posn observer{longitude_deg, latitude_deg};
  ln_hrz_posn horizontal;
  ln_get_hrz_from_equ(&object, &observer, julian_day_ut, &horizontal);
  const double azimuth = (horizontal.az + 180.0) * kDegree;  // libnova counts from the south
  const double altitude = horizontal.alt * kDegree;
  return {std::cos(altitude) * std::sin(azimuth), std::sin(altitude), -std::cos(altitude) * std::cos(azimuth)};
}

double deltaT_s(double julian_day_ut) {
  return ln_get_dynamical_time_diff(julian_day_ut);
}

double eclipticLongitudeOf_deg(const Equatorial& place, double julian_day_ut) {
  ln_equ_posn object{place.right_ascension_deg, place.declination_deg};
  ln_lnlat_posn ecliptic;
  ln_get_ecl_from_equ(&object, julian_day_ut, &ecliptic);
  return ln_range_degrees(ecliptic.lng);
}

}  // namespace welkin::tests
