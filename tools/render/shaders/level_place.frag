// SPDX-License-Identifier: Apache-2.0
// Place of the visible surface: its unit normal, and its distance along the view axis.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "level.glsl"

layout(set = WELKIN_LEVEL_SET, binding = WELKIN_LEVEL_NORMAL) uniform sampler2D levelNormal;
layout(set = WELKIN_LEVEL_SET, binding = WELKIN_LEVEL_DEPTH) uniform sampler2D levelDepth;

layout(location = 0) in vec2 ndc;
layout(location = 0) out vec4 place;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  place = vec4(texelFetch(levelNormal, pixel, 0).xyz, level.camera.w / texelFetch(levelDepth, pixel, 0).r);
}
