// SPDX-License-Identifier: Apache-2.0
// Light of the volume for a list of positions and normals, and the volume's share there. PASS is 1 for that, 0 for
// reading the list alone, 2 for whether a cell along a wall is near, 3 for the sky's visibility in the far map, 4 for the
// whole ambient pass under an open sky of irradiance 1.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WELKIN_VOLUME_SET 1
#if PASS >= 3
#include "welkin/far.glsl"
#else
#include "welkin/volume.glsl"
#endif

layout(local_size_x = 64) in;
layout(set = 0, binding = 0, std430) readonly buffer Points { vec4 points[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Results { vec4 results[]; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (2 * i >= uint(points.length())) return;
  vec3 p = points[2 * i].xyz;
  vec3 normal = points[2 * i + 1].xyz;
#if PASS == 0
  results[i] = vec4(p + normal, 0.0);
#elif PASS == 1
  results[i] = vec4(welkinVolumeIrradiance(p, normal), welkinVolumeWeight(p));
#elif PASS == 3
  results[i] = vec4(welkinFarVisibility(p, normal));
#elif PASS == 4
  results[i] = vec4(mix(vec3(welkinFarVisibility(p, normal)), welkinVolumeIrradiance(p, normal), welkinVolumeWeight(p)), 0.0);
#else
  results[i] = vec4(cutBrickAt(p + welkinVolume.cuts.z * normal, p).brick != 0u ? 1.0 : 0.0);
#endif
}
