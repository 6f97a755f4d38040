// SPDX-License-Identifier: Apache-2.0
// Dear ImGui's triangles: a colour times the texture of its font, over what is there.
#version 460
#extension GL_EXT_samplerless_texture_functions : require

layout(location = 0) in vec2 texel;
layout(location = 1) in vec4 tint;
layout(set = 0, binding = 0) uniform texture2D font;
layout(location = 0, index = 0) out vec4 colour;
layout(location = 0, index = 1) out vec4 kept;  // factor on what is there

void main() {
  vec4 c = tint * texelFetch(font, ivec2(texel), 0);
  colour = vec4(c.rgb * c.a, c.a);
  kept = vec4(1.0 - c.a);
}
