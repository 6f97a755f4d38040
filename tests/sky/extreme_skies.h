// SPDX-License-Identifier: Apache-2.0
// Skies at the extremes, and a check of one of their instants.
#pragma once

#include <catch2/catch.hpp>

#include "always.h"
#include "degree.h"

namespace welkin::tests {

/// A sun that stands still.
inline model::LightPath still(double azimuth_rad, double elevation_rad) {
  model::LightPath path;
  path.key_time_h = {0.0};
  path.key_azimuth_rad = {azimuth_rad};
  path.key_elevation_rad = {elevation_rad};
  return path;
}

/// Different colours at the sun and opposite, with a ground, a tint, a moon and lights.
inline model::Sky coloured(const model::LuminanceModel& model, bool to_sun) {
  using base::Curve;
  using model::Gradient;
  model::Sky s;
  s.luminance = model;
  s.normalise_to_sun = to_sun;
  s.gradient_sun = Gradient{2, 2, {1.0F, 0.4F, 0.1F, 0.2F, 0.3F, 0.5F, 0.3F, 0.4F, 0.9F, 0.1F, 0.2F, 0.6F}};
  s.gradient_anti = Gradient{1, 2, {0.4F, 0.4F, 0.7F, 0.0F, 0.0F, 0.0F}};
  normalise(s.gradient_sun, s.gradient_anti);
  s.ground_albedo = Number3(0.3, 1.0, 0.0);
  s.polarising_tint = Curve::constant(Number3(0.9, 1.0, 1.2));
  s.sun.illuminance = Curve::constant(3.0);
  s.sun.disc_radius_rad = 0.27 * kDegree;
  s.moon.emplace();
  s.moon->path = still(1.0, 0.2);
  s.moon->illuminance = Curve::constant(1e-3);
  s.moon->disc_radius_rad = 0.25 * kDegree;
  return s;
}

/// Fails at the first fault. Returns true so that calls can be counted.
inline bool holds(const model::Sky& model, const Baked& baked, double time_h) {
  const model::SkyInstant instant(model, time_h);
  WelkinSkySample sample{};
  REQUIRE(baked.sky.sample(time_h, sample));
  CAPTURE(time_h);
  const auto require = [](const Fault& fault) {
    if (!fault.empty()) FAIL(fault);
  };
  require(faultOfSample(sample));
  for (const Number3& d : specialDirections(instant.sunDirection())) {
    CAPTURE(d.x, d.y, d.z);
    require(faultOfModel(instant, d));
    require(faultOfDirection(baked.sky, sample, d));
  }
  return true;
}

}  // namespace welkin::tests
