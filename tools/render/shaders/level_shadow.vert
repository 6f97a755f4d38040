// SPDX-License-Identifier: Apache-2.0
// A level's surfaces as the light sees them.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "level_instances.glsl"

layout(location = 0) in vec3 position;

void main() {
  vec4 p = level.shadow * vec4(placedPoint(instances[gl_InstanceIndex], position), 1.0);
  gl_Position = vec4(p.xy * 2.0 - 1.0, p.z, 1.0);
}
