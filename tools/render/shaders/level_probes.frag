// SPDX-License-Identifier: Apache-2.0
// Radiance of a white diffuse sphere lit by a probe.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "level_view.glsl"

layout(location = 0) in vec3 ray;  // from the camera
layout(location = 1) flat in vec3 centre;
layout(location = 2) flat in vec3 probe[4];
layout(location = 0) out vec4 radiance;

void main() {
  vec3 direction = normalize(ray);
  float along = dot(direction, centre);
  vec3 across = direction * along - centre;  // from the centre to the ray's nearest point
  float left = WELKIN_PROBE_RADIUS * WELKIN_PROBE_RADIUS - dot(across, across);
  if (left < 0.0) discard;
  float distance_m = along - sqrt(left);
  vec3 p = level.camera.xyz + direction * distance_m;
  if (distance_m <= 0.0 || p.y < level.options.z) discard;
  vec3 normal = (across - direction * sqrt(left)) / WELKIN_PROBE_RADIUS;
  TransferWeights weight = transferWeights(normal);
  vec3 irradiance =
      probe[0] * weight.v[0] + probe[1] * weight.v[1] + probe[2] * weight.v[2] + probe[3] * weight.v[3];
  radiance = vec4(throughMist(max(irradiance, vec3(0.0)) / kPi, direction, distance_m), 1.0);
  gl_FragDepth = level.camera.w / (level.view_projection * vec4(p, 1.0)).w;
}
