// SPDX-License-Identifier: Apache-2.0
// The surfaces of the level picture as welkin/occlusion.glsl asks for them, from the camera in world axes.
#ifndef WELKIN_LEVEL_OCCLUSION_GLSL
#define WELKIN_LEVEL_OCCLUSION_GLSL

#include "level.glsl"

layout(set = WELKIN_LEVEL_SET, binding = WELKIN_LEVEL_NORMAL) uniform sampler2D levelNormal;
layout(set = WELKIN_LEVEL_SET, binding = WELKIN_LEVEL_DEPTH) uniform sampler2D levelDepth;

ivec2 levelPixelAt(vec2 ndc) { return ivec2((ndc * 0.5 + 0.5) * vec2(textureSize(levelDepth, 0))); }

vec3 levelPlaceAt(ivec2 pixel) {
  vec2 ndc = (vec2(pixel) + 0.5) / vec2(textureSize(levelDepth, 0)) * 2.0 - 1.0;
  return (level.rays * vec4(ndc, 0.5, 1.0)).xyz * (level.camera.w / max(texelFetch(levelDepth, pixel, 0).r, 1e-9));
}

vec3 levelProject(vec3 p) {
  vec4 clip = level.view_projection * vec4(p, 0.0);
  return vec3((clip.xy + clip.w) * 0.5 * vec2(textureSize(levelDepth, 0)), clip.w);
}

#define WELKIN_OCCLUSION_POSITION(pixel) levelPlaceAt(pixel)
#define WELKIN_OCCLUSION_NORMAL(pixel) texelFetch(levelNormal, pixel, 0).xyz
#define WELKIN_OCCLUSION_PROJECT(p) levelProject(p)
#define WELKIN_OCCLUSION_SIZE textureSize(levelDepth, 0)

#endif
