// SPDX-License-Identifier: Apache-2.0
#include "sky/model/sky.h"

#include <algorithm>

namespace welkin::model {

SkyInstant::SkyInstant(const Sky& sky, double time_h)
    : sky_(&sky),
      time_h_(format::wrapTime(time_h)),
      sun_(sky.sun.path.directionAt(time_h)),
      norm_(det::luminanceNorm(sky.luminance, sun_, sky.normalise_to_sun)),
      at_right_angle_(det::exp(sky.luminance.d * det::kHalfPi)),
      intensity_(sky.intensity.at(time_h)),
      tint_(sky.polarising_tint.colourAt(time_h)),
      sun_column_(columnAt(sky.gradient_sun, time_h)),
      anti_column_(columnAt(sky.gradient_anti, time_h)) {}

double SkyInstant::luminance(const DomeRay& ray, const IndicatrixTable* table) const {
  const LuminanceModel& model = sky_->luminance;
  if (table == nullptr) {
    const double angle = det::angleBetween(ray.direction, sun_);
    return ray.gradation * det::indicatrixFrom(model, det::exp(model.d * angle), at_right_angle_, det::cos(angle)) /
           norm_;
  }
  const Number3 difference = ray.direction - sun_;
  const Number3 sum = ray.direction + sun_;
  const double to_sun = 0.25 * dot(difference, difference);
  const double to_antipode = 0.25 * dot(sum, sum);
  return ray.gradation *
         det::indicatrixFrom(model, table->exponential(to_sun, to_antipode), at_right_angle_, to_antipode - to_sun) /
         norm_;
}

Number3 SkyInstant::chromaticity(const Number3& direction, double elevation_rad) const {
  const Number3 colour =
      mix(anti_column_.at(elevation_rad), sun_column_.at(elevation_rad), det::azimuthWeight(direction, sun_));
  return det::chromaticity(colour, kGradientDelta);
}

Number3 SkyInstant::groundRadiance(const Number3& shape_irradiance) const {
  Number3 horizontal =
      shape_irradiance * intensity_ + det::levelIrradiance(sky_->sun.normalIrradianceAt(time_h_), sun_);
  if (sky_->moon)
    horizontal += det::levelIrradiance(sky_->moon->normalIrradianceAt(time_h_), sky_->moon->path.directionAt(time_h_));
  return det::groundRadiance(sky_->ground_albedo, horizontal);
}

}  // namespace welkin::model
