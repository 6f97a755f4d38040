// SPDX-License-Identifier: Apache-2.0
// The sea: a horizontal plane without an edge, drawn as four triangles from the point under the camera to infinity.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "level.glsl"

const vec2 kSides[4] = vec2[](vec2(1.0, 0.0), vec2(0.0, 1.0), vec2(-1.0, 0.0), vec2(0.0, -1.0));

void main() {
  int corner = gl_VertexIndex % 3;
  vec2 side = kSides[(gl_VertexIndex / 3 + corner + 3) % 4];
  gl_Position = level.view_projection * (corner == 0 ? vec4(level.camera.x, level.water.x, level.camera.z, 1.0)
                                                     : vec4(side.x, 0.0, side.y, 0.0));
}
