// SPDX-License-Identifier: Apache-2.0
#include "probes/reference/distant_light.h"

#include <algorithm>
#include <cmath>

#include "probes/geometry/directions.h"
#include "sky/model/projection.h"

namespace welkin::reference {
namespace {

constexpr double kConverged = 1e-9;  // relative error of the quadrature of the horizontal irradiance

/// Share of directions that are drawn near the sun: lobe / (lobe + 1) / 2, from the lobe c exp(d angle) of the
/// indicatrix over a sky of 1. The other directions keep every weight below 2.
double shareOf(const model::LuminanceModel& model) {
  constexpr double kBroad = -2.0;  // a wider lobe is not a peak
  if (model.c <= 0.0 || model.d > kBroad) return 0.0;
  const double lobe = model.c / (1.0 + model.d * model.d);  // integral over the sphere, over 2 pi
  return 0.5 * lobe / (1.0 + lobe);
}

}  // namespace

DistantLight::DistantLight(const model::Sky& sky, double time_h)
    : instant_(sky, time_h), saturation_(sky.ambient_saturation.at(time_h)), lobe_share_(shareOf(sky.luminance)) {
  const auto add = [&](const model::Light& light) {
    const Number3 direction = light.path.directionAt(time_h);
    const Number3 irradiance = light.normalIrradianceAt(time_h);
    if (direction.y > 0.0 && irradiance != Number3(0.0)) light_.push_back({direction, irradiance});
  };
  add(sky.sun);
  if (sky.moon) add(*sky.moon);
  const model::SkyProjector projector(sky.luminance, 1, kConverged);
  const Number3 under_sky =
      det::desaturate(projector.project(instant_).horizontal_irradiance, saturation_) * instant_.intensity();
  Number3 under_lights(0.0);
  for (const DirectionalLight& light : light_) under_lights += light.irradiance * light.direction.y;
  ground_under_sky_ = sky.ground_albedo * under_sky / det::kPi;
  ground_under_lights_ = sky.ground_albedo * under_lights / det::kPi;
}

Number3 DistantLight::skyRadiance(const Number3& direction) const {
  return det::desaturate(instant_.shape(direction), saturation_) * instant_.intensity();
}

bool DistantLight::sampleLobe(double s, double t, double extra, Number3& direction) const {
  const double angle = (det::log(1.0 - s) + det::log(1.0 - extra)) / instant_.sky().luminance.d;
  if (angle >= det::kPi) return false;
  const double sine = det::sin(angle);
  const Number3& sun = instant_.sunDirection();
  direction = geometry::cosineDirection(angle < det::kHalfPi ? sun : -sun, std::min(sine * sine, 1.0), t);
  return true;
}

double DistantLight::lobeDensity(const Number3& direction) const {
  const double angle = det::angleBetween(direction, instant_.sunDirection());
  const double sine = det::sin(angle);
  const double d = instant_.sky().luminance.d;
  const double stretch = sine > 0.0 ? angle / sine : 1.0;
  return d * d * stretch * det::exp(d * angle) / det::kTwoPi;
}

}  // namespace welkin::reference
