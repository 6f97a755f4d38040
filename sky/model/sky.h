// SPDX-License-Identifier: Apache-2.0
// The sky model: an artist's description and its radiance at an instant, in double.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sky/model/dome_ray.h"
#include "sky/model/gradient.h"
#include "sky/model/indicatrix_table.h"
#include "sky/model/light.h"
#include "sky/model/luminance.h"

namespace welkin::model {

using det::Number3;

/// A star map, drawn on the dome only. See shaders/shared/stars.glsl for its orientation.
struct Stars {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  ///< sRGB-encoded, rows from the celestial north pole, alpha 255
  double intensity = 0.0;          ///< radiance of white, scene units
  double latitude_rad = 0.0;
  double north_offset_rad = 0.0;
  double midnight_h = 0.0;  ///< clock time at which the middle column crosses the meridian
};

/// A sky over one day. docs/conventions.md has every formula.
struct Sky {
  LuminanceModel luminance = *findLuminance("far-cry-3");
  bool normalise_to_sun = true;  ///< false: to the zenith
  base::Curve intensity = base::Curve::constant(1.0);
  Gradient gradient_sun;   ///< at the sun's azimuth; normalised together with the other
  Gradient gradient_anti;  ///< opposite
  base::Curve polarising_tint = base::Curve::constant(Number3(1.0));
  base::Curve ambient_saturation = base::Curve::constant(1.0);
  Number3 ground_albedo{0.0};
  double luminance_unit = 1.0;  ///< cd/m2 of radiance 1
  Light sun;
  std::optional<Light> moon;
  std::optional<Stars> stars;
};

/// The sky at one time. Radiances are RGB in scene units; directions are unit vectors.
class SkyInstant {
 public:
  /// `time_h` must be finite.
  SkyInstant(const Sky& sky, double time_h);

  const Sky& sky() const { return *sky_; }
  double time_h() const { return time_h_; }
  const Number3& sunDirection() const { return sun_; }
  double intensity() const { return intensity_; }
  const GradientColumn& sunColumn() const { return sun_column_; }
  const GradientColumn& antiColumn() const { return anti_column_; }
  double luminanceNorm() const { return norm_; }
  /// exp(d pi/2) of the luminance model.
  double atRightAngle() const { return at_right_angle_; }

  /// Relative luminance, without intensity; 0 below the horizon.
  double luminance(const Number3& direction) const {
    return det::relativeLuminance(sky_->luminance, direction, sun_, norm_);
  }
  /// Colour of luminance 1 at a direction above the horizon.
  Number3 chromaticity(const Number3& direction) const { return chromaticity(direction, det::elevationOf(direction)); }
  /// The sky's radiance at intensity 1, without ground, tint, sun and moon; black below the horizon.
  Number3 shape(const Number3& direction) const {
    return direction.y < 0.0 ? Number3(0.0) : chromaticity(direction) * luminance(direction);
  }
  /// Radiance with intensity. Below the horizon it is `ground`.
  Number3 radiance(const Number3& direction, const Number3& ground) const {
    return direction.y < 0.0 ? ground : shape(direction) * intensity_;
  }
  /// The radiance that dome and cubemaps show, with the tint above the horizon. `table`, for this sky's luminance,
  /// gives the indicatrix within IndicatrixTable::kError in half the time. Null selects the exact one.
  Number3 dome(const Number3& direction, const Number3& ground, const IndicatrixTable* table = nullptr) const {
    return direction.y < 0.0 ? ground : dome(DomeRay(sky_->luminance, direction), table);
  }
  /// The same, to the last bit, along a ray of this sky's luminance model that is not below the horizon.
  Number3 dome(const DomeRay& ray, const IndicatrixTable* table) const {
    return chromaticity(ray.direction, ray.elevation_rad) * luminance(ray, table) * intensity_ * tint_;
  }
  /// Radiance of the ground under the sky's horizontal irradiance at intensity 1 (`shape_irradiance`), sun and moon.
  Number3 groundRadiance(const Number3& shape_irradiance) const;

 private:
  double luminance(const DomeRay& ray, const IndicatrixTable* table) const;
  Number3 chromaticity(const Number3& direction, double elevation_rad) const;

  const Sky* sky_;
  double time_h_;
  Number3 sun_;
  double norm_;
  double at_right_angle_;  ///< exp(d pi/2)
  double intensity_;
  Number3 tint_;
  GradientColumn sun_column_;
  GradientColumn anti_column_;
};

}  // namespace welkin::model
