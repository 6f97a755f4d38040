// SPDX-License-Identifier: Apache-2.0
// The star map, to be added to the dome. Has the requirements of constants.glsl, and WELKIN_BINDING_STARS of
// sky_bindings.h.
#ifndef WELKIN_STARS_GLSL
#define WELKIN_STARS_GLSL

#ifndef WELKIN_BINDING_STARS
#error WELKIN_BINDING_STARS is not defined: include welkin/sky_bindings.h, or give the binding of the texture
#endif

#include "constants.glsl"
#include "formulas.glsl"

layout(set = WELKIN_SET, binding = WELKIN_BINDING_STARS) uniform sampler2D welkinStarMap;

// Radiance of the stars in unit `direction`, faded by `sky`, the dome's radiance there. 0 below the horizon.
vec3 welkinStars(vec3 direction, vec3 sky) {
  vec3 at = starCoordinates(direction, welkinSky.stars.x, welkinSky.stars.y, welkinSky.stars.z);
  vec3 map = textureLod(welkinStarMap, at.xy, 0.0).rgb;
  float seen = direction.y < 0.0 ? 0.0 : starFade(luminanceOf(sky), max(welkinSky.stars.w, 1e-30));
  return map * (welkinSky.stars.w * seen);
}

#endif
