// SPDX-License-Identifier: Apache-2.0
// The cube around a probe's sphere. level_probes.frag finds the sphere inside it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "level.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 irradiance[4];
layout(location = 0) out vec3 ray;  // from the camera
layout(location = 1) flat out vec3 centre;
layout(location = 2) flat out vec3 probe[4];

const vec2 kCorners[6] = vec2[](vec2(-1.0, -1.0), vec2(1.0, -1.0), vec2(1.0, 1.0), vec2(-1.0, -1.0), vec2(1.0, 1.0),
                                vec2(-1.0, 1.0));

void main() {
  int face = gl_VertexIndex / 6;
  vec3 p = vec3(kCorners[gl_VertexIndex % 6], face < 3 ? 1.0 : -1.0);
  p = face % 3 == 0 ? p.xyz : face % 3 == 1 ? p.yzx : p.zxy;
  centre = position - level.camera.xyz;
  ray = centre + p * WELKIN_PROBE_RADIUS;
  probe = irradiance;
  gl_Position = level.view_projection * vec4(position + p * WELKIN_PROBE_RADIUS, 1.0);
}
