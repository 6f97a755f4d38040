// SPDX-License-Identifier: Apache-2.0
// One triangle that covers the viewport. `point` is the position on the picture in radii of the ball, y down.
#version 460
layout(location = 0) out vec2 point;

void main() {
  vec2 ndc = vec2(gl_VertexIndex == 1 ? 3.0 : -1.0, gl_VertexIndex == 2 ? 3.0 : -1.0);
  point = ndc * vec2(2.0, 1.0) / 0.75;
  gl_Position = vec4(ndc, 0.0, 1.0);
}
