// SPDX-License-Identifier: Apache-2.0
// Directions of the points of a picture. Normalised device coordinates are Vulkan's: x right, y down, in [-1, 1].
#ifndef WELKIN_VIEW_GLSL
#define WELKIN_VIEW_GLSL

#include "formulas.glsl"

// Direction through a point of a perspective picture. The matrix is the inverse of projection times view rotation,
// without the camera's translation. Either depth convention works, infinite planes included.
vec3 welkinPerspectiveDirection(mat4 inverse_view_projection, vec2 ndc) {
  return normalize((inverse_view_projection * vec4(ndc, 0.5, 1.0)).xyz);
}

// Direction through a point of the unit disc that shows the upper hemisphere to an observer lying on their back, head
// to the north. The zenith is in the centre, the horizon on the rim, north up, EAST TO THE LEFT. Equidistant: the angle
// from the zenith is the radius times pi/2. Valid for length(p) <= 1.
vec3 welkinFisheyeDirection(vec2 p) {
  float radius = min(length(p), 1.0);
  float horizontal = radius < 1e-4 ? kHalfPi : sin(radius * kHalfPi) / radius;
  return vec3(-p.x * horizontal, max(cos(radius * kHalfPi), 0.0), p.y * horizontal);
}

#endif
