// SPDX-License-Identifier: Apache-2.0
// Corners of Dear ImGui's triangles, from pixels to device coordinates.
#version 460

layout(location = 0) in vec2 position;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 colour;
layout(location = 0) out vec2 texel;
layout(location = 1) out vec4 tint;
layout(push_constant) uniform Push {
  vec2 to_device;  // 2 / size of the picture
  vec2 font_size;  // texels
}
push;

void main() {
  texel = uv * push.font_size;
  tint = colour;
  gl_Position = vec4(position * push.to_device - 1.0, 0.0, 1.0);
}
