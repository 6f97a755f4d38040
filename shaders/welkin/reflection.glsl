// SPDX-License-Identifier: Apache-2.0
// Reflection of the sky on glossy surfaces from the cubemaps' mips. `direction` is the mirrored view, unit, in world
// axes. Has the same requirements as dome.glsl.
#ifndef WELKIN_REFLECTION_GLSL
#define WELKIN_REFLECTION_GLSL

#include "dome.glsl"

// Radiance averaged over about the reflected lobe of `gloss` in [0, 1], specular power 2^(13 gloss) (McAuley 2012). The
// mip is the one whose texel has the lobe's solid angle, 8 pi / (power + 4) (Mittring and Crytek 2010: a reflected lobe
// has a quarter of the half-vector's power). The mips are box filters, so this is an approximation. It is exact for a
// mirror.
vec3 welkinSkyReflection(vec3 direction, float gloss) {
  float power = exp2(13.0 * clamp(gloss, 0.0, 1.0));
  float edge = float(textureSize(welkinCubemapFirst, 0).x);
  float lod = max(0.5 * log2(12.0 * edge * edge / (power + 4.0)), 0.0);
  return mix(textureLod(welkinCubemapFirst, direction, lod).rgb, textureLod(welkinCubemapSecond, direction, lod).rgb,
             welkinSky.ground.w);
}

#endif
