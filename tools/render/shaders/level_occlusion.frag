// SPDX-License-Identifier: Apache-2.0
// Visibility of a surface's hemisphere, noisy.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "level_occlusion.glsl"
#include "welkin/occlusion.glsl"

layout(location = 0) in vec2 ndc;
layout(location = 0) out vec4 visibility;

void main() { visibility = vec4(vec3(welkinOcclusionVisibility(levelPixelAt(ndc))), 1.0); }
