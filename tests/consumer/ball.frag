// SPDX-License-Identifier: Apache-2.0
// A ball under the sky, seen from the south without perspective: half ambient light, half the sky along its normal.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WELKIN_SET 0
#include "welkin/sky_bindings.h"
#include "welkin/ambient.glsl"
#include "welkin/dome.glsl"

layout(location = 0) in vec2 point;
layout(location = 0) out vec4 radiance;

void main() {
  float square = dot(point, point);
  if (square >= 1.0) discard;
  vec3 normal = vec3(point.x, -point.y, sqrt(1.0 - square));
  radiance = vec4(0.5 * (welkinDomeRadiance(normal) + welkinIrradianceOverPi(normal)), 1.0);
}
