// SPDX-License-Identifier: Apache-2.0
// The one directional light of the scene: the sun, or the moon when it gives more (welkin_sample_key_light). It has no
// shadows; a game multiplies its own. Has the same requirements as constants.glsl.
#ifndef WELKIN_SUN_GLSL
#define WELKIN_SUN_GLSL

#include "constants.glsl"

// Unit direction towards the light.
vec3 welkinSunDirection() { return welkinSky.key_direction.xyz; }

// Irradiance E (pi included) of a surface with unit `normal`. 0 below the horizon, and continuous when the light rises.
vec3 welkinSunIrradiance(vec3 normal) {
  return welkinSky.key_irradiance.rgb * max(dot(normal, welkinSky.key_direction.xyz), 0.0);
}

#endif
