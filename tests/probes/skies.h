// SPDX-License-Identifier: Apache-2.0
// Skies for levels with closed forms, and a check of estimates against them.
#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "probes/geometry/directions.h"
#include "probes/reference/reference.h"

namespace welkin::tests {

/// A sky with the same radiance everywhere above the horizon. The sun stands still and gives no light.
inline model::Sky uniformSky(double radiance, double sun_azimuth_rad = 0.4, double sun_elevation_rad = 0.7) {
  model::Sky sky;
  sky.luminance = *model::findLuminance("cie-5");
  sky.normalise_to_sun = false;
  sky.intensity = base::Curve::constant(radiance);
  sky.sun.path.key_time_h = {0.0};
  sky.sun.path.key_azimuth_rad = {sun_azimuth_rad};
  sky.sun.path.key_elevation_rad = {sun_elevation_rad};
  return sky;
}

/// A black sky with a sun of white normal irradiance.
inline model::Sky sunOnly(double irradiance, double azimuth_rad, double elevation_rad) {
  model::Sky sky = uniformSky(0.0, azimuth_rad, elevation_rad);
  sky.sun.illuminance = base::Curve::constant(irradiance);
  return sky;
}

/// A clear sky, brightest about the sun, coloured by azimuth and elevation, with a sun.
inline model::Sky clearSky(double azimuth_rad, double elevation_rad) {
  model::Sky sky = sunOnly(3.0, azimuth_rad, elevation_rad);
  sky.luminance = *model::findLuminance("far-cry-3");
  sky.normalise_to_sun = true;
  sky.intensity = base::Curve::constant(1.5);
  sky.sun.colour = base::Curve::constant(f64::Number3(1.0, 0.8, 0.5));
  sky.gradient_sun = {1, 2, {1.0F, 0.6F, 0.3F, 0.3F, 0.5F, 0.9F}};
  sky.gradient_anti = {1, 2, {0.5F, 0.6F, 0.8F, 0.2F, 0.4F, 0.9F}};
  normalise(sky.gradient_sun, sky.gradient_anti);
  return sky;
}

/// No light from outside.
inline reference::DistantLight darkness() {
  static const model::Sky sky = uniformSky(0.0);
  return {sky, 12.0};
}

/// Sum of albedo^i, i from `first` to `last`.
inline f64::Number3 bounces(const f64::Number3& albedo, int first, int last) {
  f64::Number3 sum(0.0);
  f64::Number3 power(1.0);
  for (int i = 0; i <= last; ++i) {
    if (i >= first) sum += power;
    power = power * albedo;
  }
  return sum;
}

inline const f64::Number3 kAlbedo(0.2, 0.5, 0.9);
inline const std::vector<f64::Number3> kNormals = {
    {0, 1, 0}, {0, -1, 0}, geometry::unit({0.3, 0.5, -0.7}), geometry::unit({-0.8, -0.1, 0.4})};

inline constexpr double kStandardErrors = 3.0;
inline constexpr double kRounding = 1e-12;  ///< relative; rounding of sums of many doubles

/// Checks an estimate, within its standard errors and the level's own error.
inline void checkEstimate(const reference::Estimate& estimate, const f64::Number3& expected, double level_bound = 0.0) {
  for (int c = 0; c < 3; ++c) {
    INFO("channel " << c << ": " << estimate.value[c] << " +- " << estimate.standard_error[c] << ", expected "
                    << expected[c]);
    CHECK(std::abs(estimate.value[c] - expected[c]) <=
          kStandardErrors * estimate.standard_error[c] + kRounding * std::abs(expected[c]) + level_bound);
  }
}

}  // namespace welkin::tests
