// SPDX-License-Identifier: Apache-2.0
// The discs of the sun and the moon, to be added to the dome. A disc of angular radius r and normal irradiance E has
// the radiance E / (pi sin^2 r). Has the same requirements as constants.glsl.
#ifndef WELKIN_DISCS_GLSL
#define WELKIN_DISCS_GLSL

#include "constants.glsl"
#include "formulas.glsl"

// Radiance of both discs in `direction`. Edges are softened over `pixel_rad`, the angle between neighbouring pixels.
// The moon shows its phase. 0 below the horizon.
vec3 welkinDiscs(vec3 direction, float pixel_rad) {
  vec3 sum = vec3(0.0);
  if (direction.y < 0.0) return sum;
  float sun_coverage = discCoverage(angleBetween(direction, welkinSky.sun.xyz), welkinSky.sun_disc.w, pixel_rad);
  float moon_coverage = discCoverage(angleBetween(direction, welkinSky.moon.xyz), welkinSky.moon_disc.w, pixel_rad);
  sum += welkinSky.sun_disc.rgb * sun_coverage;
  if (moon_coverage > 0.0)
    sum += welkinSky.moon_disc.rgb *
           (moon_coverage * moonPhase(direction, welkinSky.moon.xyz, welkinSky.moon_disc.w, welkinSky.sun.xyz));
  return sum;
}

#endif
