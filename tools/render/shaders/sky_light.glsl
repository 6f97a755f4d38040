// SPDX-License-Identifier: Apache-2.0
// Ambient light of the sky: the file's best light, which its certificate describes, and the light of one colour. With
// WELKIN_LIGHT_OF_MODES the best light comes from the modes, otherwise from the coefficients.
#ifndef WELKIN_SKY_LIGHT_GLSL
#define WELKIN_SKY_LIGHT_GLSL

#include "welkin/ambient.glsl"
#ifdef WELKIN_LIGHT_OF_MODES
#include "welkin/modes.glsl"
vec3 skyIrradiance(vec3 normal) { return welkinModesIrradiance(normal); }
#else
vec3 skyIrradiance(vec3 normal) { return welkinIrradiance(normal); }
#endif

#endif
