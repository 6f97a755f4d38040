// SPDX-License-Identifier: Apache-2.0
// Reads the filtered sky in a list of directions, each at its own gloss.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WELKIN_REFLECTION_SET 1
#include "welkin/reflected_sky.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0, std430) readonly buffer Directions { vec4 directions[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Results { vec4 results[]; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= uint(directions.length())) return;
  results[i] = vec4(welkinReflectedSky(directions[i].xyz, directions[i].w), float(textureQueryLevels(welkinReflectedChain)));
}
