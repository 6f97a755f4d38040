// SPDX-License-Identifier: Apache-2.0
// Light of the volume for a list of positions and normals, and the volume's share there.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WELKIN_VOLUME_SET 1
#include "welkin/volume.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0, std430) readonly buffer Points { vec4 points[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Results { vec4 results[]; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (2 * i >= uint(points.length())) return;
  vec3 p = points[2 * i].xyz;
  results[i] = vec4(welkinVolumeIrradiance(p, points[2 * i + 1].xyz), welkinVolumeWeight(p));
}
