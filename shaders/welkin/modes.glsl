// SPDX-License-Identifier: Apache-2.0
// Ambient light of the sky from the modes of its irradiance. For a file with modes the certificate applies to this
// light.
// `normal` is unit, in world axes.
// Needs: #extension GL_GOOGLE_include_directive : require, WELKIN_SET, WELKIN_BINDING_CONSTANTS, WELKIN_BINDING_MODES.
#ifndef WELKIN_MODES_GLSL
#define WELKIN_MODES_GLSL

#include "constants.glsl"
#include "formulas.glsl"

#ifndef WELKIN_BINDING_MODES
#error WELKIN_BINDING_MODES is not defined: include welkin/sky_bindings.h, or give the binding of the modes' map
#endif

// Modes to evaluate, 4, 8 or 12: one texture read for every four. The default fits every bake. A game whose bake has no
// more than 4 or 8 modes, as all bakes of 1 % have, may define that number before it includes this file.
#ifndef WELKIN_MODES
#define WELKIN_MODES 12
#endif

#ifdef WELKIN_BINDING_MODES_SAMPLER  // a sampler of its own, for a layout without combined ones
layout(set = WELKIN_SET, binding = WELKIN_BINDING_MODES) uniform texture2DArray welkinModesTexture;
layout(set = WELKIN_SET, binding = WELKIN_BINDING_MODES_SAMPLER) uniform sampler welkinModesSampler;
#define welkinModesMap sampler2DArray(welkinModesTexture, welkinModesSampler)
#else
layout(set = WELKIN_SET, binding = WELKIN_BINDING_MODES) uniform sampler2DArray welkinModesMap;
#endif

// Irradiance of four modes in red, green and blue. `first` is their place in mode_weight.
vec3 welkinModesOfLayer(vec2 at, float layer, int first) {
  vec4 mode = textureLod(welkinModesMap, vec3(at, layer), 0.0);
  return vec3(dot(mode, welkinSky.mode_weight[first]), dot(mode, welkinSky.mode_weight[first + 1]),
              dot(mode, welkinSky.mode_weight[first + 2]));
}

// Irradiance E, pi included, clamped at 0, as welkin_sky_irradiance computes it. A normal that looks down takes the
// modes of the opposite normal plus the difference of the two. That difference is linear in the normal and the ground's
// share is linear in |y|, so it is one product with a vector for each channel. A device filters with weights of b bits,
// VkPhysicalDeviceLimits::subTexelPrecisionBits, 8 on common ones. So the error of each mode is at most 2^-b times the
// sum of its differences to the next column and the next row.
vec3 welkinModesIrradiance(vec3 normal) {
  vec4 frame = welkinSky.mode_frame;
  vec4 texels = welkinSky.mode_texels;
  bool down = normal.y < 0.0;
  vec3 up = normal * mix(1.0, -1.0, down);
  float horizontal = horizontalLength(up);
  vec2 at = vec2(modeColumn(up, horizontal, frame.x, frame.y), modeRow(horizontal, up.y)) * texels.xy + texels.zw;
  vec4 rest = vec4(normal * mix(frame.z, 1.0, down), 1.0 - frame.w * up.y);
  vec3 sum = vec3(dot(rest, welkinSky.mode_rest[0]), dot(rest, welkinSky.mode_rest[1]), dot(rest, welkinSky.mode_rest[2]));
  sum += welkinModesOfLayer(at, 0.0, 0);
#if WELKIN_MODES > 4
  sum += welkinModesOfLayer(at, 1.0, 3);
#endif
#if WELKIN_MODES > 8
  sum += welkinModesOfLayer(at, 2.0, 6);
#endif
  return max(sum, vec3(0.0));
}

// E / pi. Multiplied by an albedo it is the radiance of a diffuse surface.
vec3 welkinModesIrradianceOverPi(vec3 normal) { return welkinModesIrradiance(normal) / kPi; }

#endif
