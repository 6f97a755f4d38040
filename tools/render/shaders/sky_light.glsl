// SPDX-License-Identifier: Apache-2.0
// The best ambient light of a file, which its certificate speaks of: from its modes with WELKIN_LIGHT_OF_MODES, else from
// its coefficients; and the light of one colour.
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
