// SPDX-License-Identifier: Apache-2.0
// Radiance of the sky dome. `direction` is unit, in world axes. Below the horizon (y < 0) the result is the ground's
// radiance. The sun and moon are not included (discs.glsl).
// Relative luminance x chromaticity of the gradients x intensity x polarising tint: McAuley, "Calibrating Lighting and
// Materials in Far Cry 3", SIGGRAPH 2012 course notes; shared/luminance.glsl.
// Needs: #extension GL_GOOGLE_include_directive : require, WELKIN_SET, and the WELKIN_BINDING_... of sky_bindings.h.
#ifndef WELKIN_DOME_GLSL
#define WELKIN_DOME_GLSL

#ifndef WELKIN_BINDING_GRADIENT_SUN
#error WELKIN_BINDING_GRADIENT_SUN is not defined: include welkin/sky_bindings.h, or give the binding of the texture
#endif
#ifndef WELKIN_BINDING_GRADIENT_ANTI
#error WELKIN_BINDING_GRADIENT_ANTI is not defined: include welkin/sky_bindings.h, or give the binding of the texture
#endif
#ifndef WELKIN_BINDING_CUBEMAP_FIRST
#error WELKIN_BINDING_CUBEMAP_FIRST is not defined: include welkin/sky_bindings.h, or give the binding of the texture
#endif
#ifndef WELKIN_BINDING_CUBEMAP_SECOND
#error WELKIN_BINDING_CUBEMAP_SECOND is not defined: include welkin/sky_bindings.h, or give the binding of the texture
#endif

#include "constants.glsl"
#include "formulas.glsl"

layout(set = WELKIN_SET, binding = WELKIN_BINDING_GRADIENT_SUN) uniform sampler2D welkinGradientSun;
layout(set = WELKIN_SET, binding = WELKIN_BINDING_GRADIENT_ANTI) uniform sampler2D welkinGradientAnti;
layout(set = WELKIN_SET, binding = WELKIN_BINDING_CUBEMAP_FIRST) uniform samplerCube welkinCubemapFirst;
layout(set = WELKIN_SET, binding = WELKIN_BINDING_CUBEMAP_SECOND) uniform samplerCube welkinCubemapSecond;

// Filters bilinearly in 32-bit floats, because a filtering unit rounds its weights to 8 bits. `column` holds the left
// column and the weight of the next, which wraps. Rows clamp; row 0 is at the horizon.
vec3 welkinGradient(sampler2D gradient, vec2 size, vec2 column, float elevation_rad) {
  float row = gradientRow(elevation_rad, size.y);
  int left = int(column.x);
  int right = left + 1 - int(size.x) * int(left + 1 == int(size.x));
  int low = int(row);
  int high = min(low + 1, int(size.y) - 1);
  vec3 below = mix(texelFetch(gradient, ivec2(left, low), 0).rgb, texelFetch(gradient, ivec2(right, low), 0).rgb, column.y);
  vec3 above = mix(texelFetch(gradient, ivec2(left, high), 0).rgb, texelFetch(gradient, ivec2(right, high), 0).rgb, column.y);
  return mix(below, above, row - float(low));
}

// Radiance from the formulas and the gradients, exact at every hour.
vec3 welkinDomeRadiance(vec3 direction) {
  if (direction.y < 0.0) return welkinSky.ground.rgb;
  LuminanceModel model = LuminanceModel(welkinSky.luminance_abcd.x, welkinSky.luminance_abcd.y, welkinSky.luminance_abcd.z,
                                        welkinSky.luminance_abcd.w, welkinSky.luminance_ek.x, welkinSky.luminance_ek.y);
  float luminance = relativeLuminance(model, direction, welkinSky.sun.xyz, welkinSky.luminance_ek.z);
  float elevation_rad = elevationOf(direction);
  vec3 towards = welkinGradient(welkinGradientSun, welkinSky.gradient_size.xy, welkinSky.gradient_column.xy, elevation_rad);
  vec3 away = welkinGradient(welkinGradientAnti, welkinSky.gradient_size.zw, welkinSky.gradient_column.zw, elevation_rad);
  vec3 colour = mix(away, towards, azimuthWeight(direction, welkinSky.sun.xyz));
  return chromaticity(colour, welkinSky.tint.w) * (luminance * welkinSky.luminance_ek.w) * welkinSky.tint.rgb;
}

// Radiance from the baked cubemaps: two texture reads, blended between their hours. Tint and ground are included.
vec3 welkinDomeFromCubemaps(vec3 direction) {
  return mix(textureLod(welkinCubemapFirst, direction, 0.0).rgb, textureLod(welkinCubemapSecond, direction, 0.0).rgb,
             welkinSky.ground.w);
}

#endif
