// SPDX-License-Identifier: Apache-2.0
// Small shaders whose costs are known; CASE names one.
#version 460
#extension GL_EXT_control_flow_attributes : require
layout(location = 0) in vec3 given;
layout(location = 0) out vec4 result;
layout(set = 0, binding = 0, std140) uniform Block { vec4 rows[16]; };
layout(set = 0, binding = 1) uniform sampler2D image;

vec3 caseProduct() { return given * rows[3].rgb; }

vec3 caseWeightedInLoops() {
  float weights[6];
  for (int i = 0; i < 6; ++i) weights[i] = float(i + 2) * given.x;
  vec3 sum = vec3(0.0);
  for (int band = 0; band < 3; ++band) {
    for (int i = 0; i < 2; ++i) sum += weights[2 * band + i] * rows[2 * band + i].rgb;
  }
  return sum;
}

vec3 caseWeightedByHand() {
  vec3 sum = (2.0 * given.x) * rows[0].rgb;
  sum += (3.0 * given.x) * rows[1].rgb;
  sum += (4.0 * given.x) * rows[2].rgb;
  sum += (5.0 * given.x) * rows[3].rgb;
  sum += (6.0 * given.x) * rows[4].rgb;
  return sum + (7.0 * given.x) * rows[5].rgb;
}

vec3 caseBranch() {
  if (given.x > 0.5) return vec3(sin(given.y));
  return vec3(cos(given.z));
}

vec3 caseLeftOut() {
  float all[4] = float[4](exp(given.x), exp(given.y), exp(given.z), exp(given.x + given.y));
  return vec3(all[int(2.0)] + 0.0 * all[3]);
}

vec3 caseFetchesOfOnePlace() { return texture(image, given.xy).rgb + textureLod(image, given.xy, 0.0).rgb + texture(image, given.xy).rgb; }

vec3 caseNestedBranches() {
  float x = given.x;
  if (given.y > 0.5) {
    if (given.z > 0.5) x = sqrt(x);
    x = exp2(x);
  }
  return vec3(x);
}

vec3 caseLengths() { return vec3(length(given) * dot(given, rows[0].xyz)); }

vec3 caseDataLoop() {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < int(given.x); ++i) sum = sum * rows[1].rgb + rows[0].rgb;
  return sum;
}

vec3 caseDataIndex() { return rows[int(given.x)].rgb; }

void main() { result = vec4(CASE(), 1.0); }
