// SPDX-License-Identifier: Apache-2.0
// The light that reaches a level from outside at one time, for the reference: the sky model itself, the sun, the moon,
// and the ground beyond the level.
#pragma once

#include <vector>

#include "probes/geometry/surfaces.h"
#include "sky/model/sky.h"

namespace welkin::reference {

using f64::Number3;

/// A distant light without extent.
struct DirectionalLight {
  Number3 direction;   ///< unit, towards the light
  Number3 irradiance;  ///< irradiance of a surface that faces the light, scene units
};

/// Immutable after construction; any thread may use it.
class DistantLight {
 public:
  /// `sky` must outlive the object; `time_h` is finite.
  DistantLight(const model::Sky& sky, double time_h);

  /// The sky's radiance at intensity, desaturated by ambient_saturation, without tint; 0 below the horizon.
  Number3 skyRadiance(const Number3& direction) const;
  /// Radiance of the ground beyond the level, which is horizontal and unobstructed, under the sky as above.
  const Number3& groundUnderSky() const { return ground_under_sky_; }
  /// The same under the sun and the moon.
  const Number3& groundUnderLights() const { return ground_under_lights_; }
  const Number3& groundAlbedo() const { return instant_.sky().ground_albedo; }
  /// The sun and the moon, if they are up and shine.
  const std::vector<DirectionalLight>& lights() const { return light_; }

  /// Share of directions to draw near the sun, in [0, 1/2]; 0 if the sky has no lobe there that is worth it.
  double lobeShare() const { return lobe_share_; }
  /// Draws a direction about the sun from three numbers in [0, 1). Its angle has density d^2 angle exp(d angle), the
  /// sum of two exponential ones. Returns false if the angle exceeds pi.
  bool sampleLobe(double s, double t, double extra, Number3& direction) const;
  /// Density of sampleLobe over solid angle, 1/sr.
  double lobeDensity(const Number3& direction) const;

 private:
  model::SkyInstant instant_;
  double saturation_;
  Number3 ground_under_sky_{0.0};
  Number3 ground_under_lights_{0.0};
  std::vector<DirectionalLight> light_;
  double lobe_share_ = 0.0;
};

}  // namespace welkin::reference
