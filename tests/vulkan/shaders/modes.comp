// SPDX-License-Identifier: Apache-2.0
// Ambient light of the modes for a list of normals.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WELKIN_SET 1
#include "welkin/sky_bindings.h"
#include "welkin/modes.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0, std430) readonly buffer Normals { vec4 normals[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Results { vec4 results[]; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= uint(normals.length())) return;
  vec3 n = normals[i].xyz;
  results[2 * i] = vec4(welkinModesIrradiance(n), 0.0);
  results[2 * i + 1] = vec4(welkinModesIrradianceOverPi(n), 0.0);
}
