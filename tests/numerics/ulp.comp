// SPDX-License-Identifier: Apache-2.0
// Evaluates every shared formula for a list of arguments; evaluate.cpp does the same on the CPU.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "welkin/materials.glsl"
#include "body.h"

#define PUT(name, size, arguments, value) results[next++] = float(value);
#define PUT3(name, size, arguments, value) put3(value);

layout(local_size_x = 64) in;
layout(set = 0, binding = 0, std430) readonly buffer Arguments { vec4 arguments_[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Results { float results[]; };

uint next;
void put3(vec3 value) {
  results[next++] = value.x;
  results[next++] = value.y;
  results[next++] = value.z;
}

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (5 * i >= uint(arguments_.length())) return;
  vec3 a = arguments_[5 * i].xyz;
  float azimuth_rad = arguments_[5 * i].w;
  vec3 b = arguments_[5 * i + 1].xyz;
  float angle_rad = arguments_[5 * i + 1].w;
  vec3 near_b = arguments_[5 * i + 2].xyz;
  float x = arguments_[5 * i + 2].w;
  vec3 rgb = arguments_[5 * i + 3].xyz;
  float up = arguments_[5 * i + 3].w;
  float theta = arguments_[5 * i + 4].x;
  float s = arguments_[5 * i + 4].y;
  float t = arguments_[5 * i + 4].z;
  next = i * WELKIN_NUMERICS_RESULTS;
  WELKIN_NUMERICS_BODY
}
