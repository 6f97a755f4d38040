// SPDX-License-Identifier: Apache-2.0
// The instances of a level's meshes, for vertex shaders.
#ifndef WELKIN_LEVEL_INSTANCES_GLSL
#define WELKIN_LEVEL_INSTANCES_GLSL

#include "level.glsl"

struct LevelInstance {
  vec4 row[3];  // of the transform, translation last
  vec4 albedo;  // alpha: metallic
  vec3 emission;
  int contact;  // of the first vertex, less gl_VertexIndex there; below -2^30: none
  vec4 gloss;   // x alone
};

layout(set = WELKIN_LEVEL_SET, binding = WELKIN_LEVEL_INSTANCES, std430) readonly buffer LevelInstances {
  LevelInstance instances[];
};

vec3 placedPoint(LevelInstance i, vec3 p) {
  vec4 q = vec4(p, 1.0);
  return vec3(dot(i.row[0], q), dot(i.row[1], q), dot(i.row[2], q));
}

// Uses the cofactor matrix, the inverse transpose times the determinant, which is exact for uneven scales.
vec3 placedNormal(LevelInstance i, vec3 n) {
  vec3 a = i.row[0].xyz;
  vec3 b = i.row[1].xyz;
  vec3 c = i.row[2].xyz;
  vec3 placed = vec3(dot(cross(b, c), n), dot(cross(c, a), n), dot(cross(a, b), n));
  return dot(a, cross(b, c)) < 0.0 ? -placed : placed;
}

#endif
