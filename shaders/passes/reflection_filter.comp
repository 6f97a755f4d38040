#version 460
// SPDX-License-Identifier: Apache-2.0
// Filters the sky dome for rough surfaces: each texel of a mip is the dome's mean over the lobe about its direction, by
// the rule of shared/reflection_lobe.glsl. The invocations of a texel share the circles of the rule. tests/sky/lobe_mean.h
// is the same in double.
#extension GL_GOOGLE_include_directive : require
#define WELKIN_SET 0
#include "welkin/sky_bindings.h"
#include "welkin/dome.glsl"
#include "welkin/materials.glsl"
#include "reflection_filter.h"

layout(local_size_x = WELKIN_REFLECTION_LANES, local_size_y = WELKIN_REFLECTION_GROUP) in;
layout(set = 1, binding = 0, rgba16f) uniform writeonly image2DArray texels;

shared vec4 sums[WELKIN_REFLECTION_LANES * WELKIN_REFLECTION_GROUP];  // light times weight, weight

const float kLargestHalf = 65504.0;

// Unit direction of a point (s, t) in [-1, 1]^2 of a face of Vulkan's cube.
vec3 cubeDirection(int face, vec2 at) {
  vec3 d = face == 0   ? vec3(1.0, -at.y, -at.x)
           : face == 1 ? vec3(-1.0, -at.y, at.x)
           : face == 2 ? vec3(at.x, 1.0, at.y)
           : face == 3 ? vec3(at.x, -1.0, -at.y)
           : face == 4 ? vec3(at.x, -at.y, 1.0)
                       : vec3(-at.x, -at.y, -1.0);
  return normalize(d);
}

// Mean of the dome over the part of a circle above the horizon.
vec3 lightAbove(LobeCircle circle, vec3 axis, int panels) {
  vec3 sum = vec3(0.0);
  for (int j = 0; j < 4 * panels; ++j) {
    vec3 d = lobeDirection(circle, axis, j, panels);
    d.y = max(d.y, 0.0);  // rounding
    sum += welkinDomeRadiance(d) * gaussWeight(j % 4);
  }
  return sum / float(2 * panels);
}

void main() {
  int texel = int(gl_WorkGroupID.x) * WELKIN_REFLECTION_GROUP + int(gl_LocalInvocationID.y);
  ivec3 at = ivec3(texel % push.edge, texel / push.edge, push.face + int(gl_WorkGroupID.z));
  vec3 axis = cubeDirection(at.z, (vec2(at.xy) + 0.5) * (2.0 / float(push.edge)) - 1.0);
  int panels_out = lobePanelsOut(push.power);
  int panels_around = lobePanelsAround(push.power);
  vec4 sum = vec4(0.0);
  for (int i = int(gl_LocalInvocationID.x); i < 8 * panels_out; i += WELKIN_REFLECTION_LANES) {
    LobeCircle circle = lobeCircle(push.power, axis, i, panels_out);
    float above = circle.turn / kPi;
    vec3 light = welkinSky.ground.rgb * (1.0 - above);
    if (above > 0.0) light += lightAbove(circle, axis, panels_around) * above;
    sum += vec4(light, 1.0) * circle.weight;
  }
  sums[gl_LocalInvocationIndex] = sum;
  barrier();
  if (gl_LocalInvocationID.x != 0 || at.y >= push.edge) return;
  for (uint lane = 1; lane < WELKIN_REFLECTION_LANES; ++lane) sum += sums[gl_LocalInvocationIndex + lane];
  imageStore(texels, at, vec4(min(sum.rgb / sum.a, vec3(kLargestHalf)), 1.0));
}
