// SPDX-License-Identifier: Apache-2.0
// The key light and the reflected sky for a list of directions.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WELKIN_SET 1
#include "welkin/sky_bindings.h"
#include "welkin/dither.glsl"
#include "welkin/reflection.glsl"
#include "welkin/sun.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0, std430) readonly buffer Directions { vec4 directions[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Results { vec4 results[]; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= uint(directions.length())) return;
  vec3 d = directions[i].xyz;
  results[4 * i] = vec4(welkinSunIrradiance(d), 0.0);
  results[4 * i + 1] = vec4(welkinSkyReflection(d, 1.0), 0.0);
  results[4 * i + 2] = vec4(welkinSkyReflection(d, 0.0), 0.0);
  results[4 * i + 3] = vec4(welkinDither(ivec2(i % 8u, i / 8u)), 0.0);
}
