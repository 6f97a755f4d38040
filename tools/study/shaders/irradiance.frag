// SPDX-License-Identifier: Apache-2.0
// Irradiance from WELKIN_BANDS bands.
#version 460
#extension GL_EXT_control_flow_attributes : require
#extension GL_GOOGLE_include_directive : require
#define WELKIN_SET 0
#include "welkin/sky_bindings.h"
#include "welkin/ambient.glsl"

layout(location = 0) in vec3 given;
layout(location = 0) out vec4 result;

void main() { result = vec4(welkinIrradiance(given), 1.0); }
