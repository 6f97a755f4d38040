// SPDX-License-Identifier: Apache-2.0
// Finds what stands between a point and a lamp, in the level's tree of boxes.
#ifndef WELKIN_LEVEL_BLOCKERS_GLSL
#define WELKIN_LEVEL_BLOCKERS_GLSL

#include "level.glsl"

struct LevelBox {
  float low[3];
  int after;  // the node that follows where the box is missed or done
  float high[3];
  int leaf;  // 8 x the index of the first triangle, plus their number; -1: the first child comes next
};

struct LevelTriangle {
  float corner[9];
};

layout(set = WELKIN_LEVEL_SET, binding = WELKIN_LEVEL_BOXES, std430) readonly buffer LevelBoxes { LevelBox boxes[]; };
layout(set = WELKIN_LEVEL_SET, binding = WELKIN_LEVEL_TRIANGLES, std430) readonly buffer LevelTriangles {
  LevelTriangle triangles[];
};

// Whether from + t along meets the box for a t in [0, far]. Kay and Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986.
// `inverse` is 1 / along, finite.
bool meetsBox(LevelBox box, vec3 from, vec3 inverse, float far) {
  vec3 a = (vec3(box.low[0], box.low[1], box.low[2]) - from) * inverse;
  vec3 b = (vec3(box.high[0], box.high[1], box.high[2]) - from) * inverse;
  vec3 enter = min(a, b);
  vec3 leave = max(a, b) * 1.000001 + 1e-6;  // against rounding
  return max(max(enter.x, enter.y), max(enter.z, 0.0)) <= min(min(leave.x, leave.y), min(leave.z, far));
}

// The same of a triangle, from either side. Moeller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection",
// Journal of Graphics Tools 2(1), 1997. A little outside of an edge counts, so that no light passes between neighbours.
bool meetsTriangle(LevelTriangle t, vec3 from, vec3 along, float far) {
  vec3 a = vec3(t.corner[0], t.corner[1], t.corner[2]);
  vec3 ab = vec3(t.corner[3], t.corner[4], t.corner[5]) - a;
  vec3 ac = vec3(t.corner[6], t.corner[7], t.corner[8]) - a;
  vec3 p = cross(along, ac);
  float determinant = dot(ab, p);
  if (determinant == 0.0) return false;
  const float kOutside = 1e-5;
  vec3 offset = from - a;
  vec3 q = cross(offset, ab);
  float u = dot(offset, p) / determinant;
  float v = dot(along, q) / determinant;
  float at = dot(ac, q) / determinant;
  return u >= -kOutside && v >= -kOutside && u + v <= 1.0 + kOutside && at > 0.0 && at < far;
}

// Whether a surface stands before from + far along.
bool isBlocked(vec3 from, vec3 along, float far) {
  vec3 inverse = 1.0 / mix(along, vec3(1e-20), lessThan(abs(along), vec3(1e-20)));
  int node = 0;
  while (node < boxes.length()) {
    LevelBox box = boxes[node];
    if (!meetsBox(box, from, inverse, far)) {
      node = box.after;
      continue;
    }
    node = box.leaf < 0 ? node + 1 : box.after;
    for (int i = box.leaf / 8; box.leaf >= 0 && i < box.leaf / 8 + box.leaf % 8; ++i)
      if (meetsTriangle(triangles[i], from, along, far)) return true;
  }
  return false;
}

#endif
