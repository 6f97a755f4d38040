// SPDX-License-Identifier: Apache-2.0
// Must not compile, because the function of the normal is missing. The message has to say so.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WELKIN_OCCLUSION_POSITION(pixel) vec3(0.0)
#include "welkin/occlusion.glsl"

void main() {}
