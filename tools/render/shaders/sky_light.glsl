// SPDX-License-Identifier: Apache-2.0
// Ambient light of the sky: the best of the file, for which its certificate holds, and the light of one colour. The
// best comes from the modes with WELKIN_LIGHT_OF_MODES, otherwise from the coefficients.
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
