// SPDX-License-Identifier: Apache-2.0
// Every shared formula for a list of arguments, WELKIN_PARITY_COUNT floats each. parity_test.cpp has them in double.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "welkin/formulas.glsl"
#include "parity.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0, std430) readonly buffer Arguments { vec4 arguments[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Results { float results[]; };

uint next;
void put(float value) { results[next++] = value; }
void put3(vec3 value) {
  put(value.x);
  put(value.y);
  put(value.z);
}

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (3 * i >= uint(arguments.length())) return;
  vec3 a = arguments[3 * i].xyz;           // unit direction
  float time_h = arguments[3 * i].w;       // [0, 24)
  vec3 b = arguments[3 * i + 1].xyz;       // unit direction
  float angle_rad = arguments[3 * i + 1].w;  // [-pi/2, pi/2]
  vec3 rgb = arguments[3 * i + 2].xyz;     // [0, 1]
  float x = arguments[3 * i + 2].w;        // [-3, 1]
  next = i * WELKIN_PARITY_COUNT;
  WELKIN_PARITY_BODY
}
