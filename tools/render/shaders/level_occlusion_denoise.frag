// SPDX-License-Identifier: Apache-2.0
// Visibility of a surface's hemisphere, without the noise of level_occlusion.frag.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "level_occlusion.glsl"

layout(set = WELKIN_LEVEL_SET, binding = WELKIN_LEVEL_NOISY) uniform sampler2D levelNoisy;

#define WELKIN_OCCLUSION_NOISY(pixel) texelFetch(levelNoisy, pixel, 0).r
#include "welkin/occlusion_denoise.glsl"

layout(location = 0) in vec2 ndc;
layout(location = 0) out vec4 visibility;

void main() { visibility = vec4(vec3(welkinOcclusionDenoised(levelPixelAt(ndc))), 1.0); }
