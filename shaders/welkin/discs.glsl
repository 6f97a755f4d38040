// SPDX-License-Identifier: Apache-2.0
// The discs of the sun and the moon, to be added to the dome. A disc of angular radius r and normal irradiance E has the
// radiance E / (pi sin^2 r). Needs what constants.glsl needs.
#ifndef WELKIN_DISCS_GLSL
#define WELKIN_DISCS_GLSL

#include "constants.glsl"
#include "formulas.glsl"

// Radiance of one disc in `direction`, its edge softened over `pixel_rad`, the angle between neighbouring pixels. Where
// the disc is smaller than a pixel its radiance is scaled so that the energy stays about the same.
vec3 welkinDisc(vec3 direction, vec3 light, vec4 disc, float pixel_rad) {
  if (disc.w <= 0.0 || direction.y < 0.0) return vec3(0.0);
  float coverage = clamp((disc.w - angleBetween(direction, light)) / max(pixel_rad, 1e-6) + 0.5, 0.0, 1.0);
  float smaller = min(2.0 * disc.w / max(pixel_rad, 1e-6), 1.0);
  return disc.rgb * (coverage * smaller * smaller);
}

// Both discs; nothing below the horizon.
vec3 welkinDiscs(vec3 direction, float pixel_rad) {
  return welkinDisc(direction, welkinSky.sun.xyz, welkinSky.sun_disc, pixel_rad) +
         welkinDisc(direction, welkinSky.moon.xyz, welkinSky.moon_disc, pixel_rad);
}

#endif
