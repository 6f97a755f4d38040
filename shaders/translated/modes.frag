// SPDX-License-Identifier: Apache-2.0
// The part of the includes that is translated to HLSL and WGSL: every function that `main` calls. Map and sampler are
// two objects, as in those languages.
#version 450
#extension GL_GOOGLE_include_directive : require
#define WELKIN_SET 0
#define WELKIN_BINDING_CONSTANTS 0
#define WELKIN_BINDING_MODES 1
#define WELKIN_BINDING_MODES_SAMPLER 2
#include "welkin/modes.glsl"

layout(location = 0) in vec3 normal;
layout(location = 0) out vec4 colour;

void main() { colour = vec4(welkinModesIrradianceOverPi(normal), 1.0); }
