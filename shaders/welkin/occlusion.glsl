// SPDX-License-Identifier: Apache-2.0
// Ambient occlusion in screen space: the share of a surface's cosine-weighted hemisphere that the surfaces of the
// picture leave free within a radius. Multiply ambient light by it, never the light of sun, moon or lamps.
//   welkinOcclusionVisibility(pixel)  in [0, 1]; noisy: the slices turn from pixel to pixel, in a pattern of 4 x 4
//   occlusion_denoise.glsl            averages that pattern
// Horizons in slices through the view direction: Jimenez, Wu, Pesce and Jarabo, "Practical Realtime Strategies for
// Accurate Indirect Occlusion", 2016 (shared/occlusion.glsl). What blocks light counts as endlessly deep along the view,
// and what the picture does not show blocks none. An open surface has exactly 1. No loop or branch depends on uniforms.
//
// Needs: #extension GL_GOOGLE_include_directive : require, and before the include these macros or functions. Vectors
// are metres from the camera in any axes, the same for all.
//   vec3 WELKIN_OCCLUSION_POSITION(ivec2 pixel)  the surface there; where there is none, a point farther than the radius
//   vec3 WELKIN_OCCLUSION_NORMAL(ivec2 pixel)    unit normal of the surface
//   vec3 WELKIN_OCCLUSION_PROJECT(vec3 p)        linear in p: coordinates in pixels times z in xy, z > 0 in sight
//   ivec2 WELKIN_OCCLUSION_SIZE                  pixels of the picture
#ifndef WELKIN_OCCLUSION_GLSL
#define WELKIN_OCCLUSION_GLSL

#ifndef WELKIN_OCCLUSION_POSITION
#error WELKIN_OCCLUSION_POSITION is not defined: a function of a pixel that gives the surface's place from the camera
#endif
#ifndef WELKIN_OCCLUSION_NORMAL
#error WELKIN_OCCLUSION_NORMAL is not defined: a function of a pixel that gives the surface's unit normal
#endif
#ifndef WELKIN_OCCLUSION_PROJECT
#error WELKIN_OCCLUSION_PROJECT is not defined: a function that gives pixels times depth, and depth, of a vector
#endif
#ifndef WELKIN_OCCLUSION_SIZE
#error WELKIN_OCCLUSION_SIZE is not defined: the width and height of the picture in pixels
#endif

// Slices a pixel, and steps on each side of a slice.
#ifndef WELKIN_OCCLUSION_SLICES
#define WELKIN_OCCLUSION_SLICES 2
#endif
#ifndef WELKIN_OCCLUSION_STEPS
#define WELKIN_OCCLUSION_STEPS 6
#endif
// Farthest surface that blocks light, metres.
#ifndef WELKIN_OCCLUSION_RADIUS_M
#define WELKIN_OCCLUSION_RADIUS_M 4.0
#endif
#include "formulas.glsl"
#include "../shared/occlusion.glsl"

// Sine of the angle above the surface under which nothing blocks light. It covers the rounding of positions and of
// half-float normals, and costs 2^-14 of the light at most.
const float kOcclusionFlat = 1.0 / 128.0;

float welkinOcclusionVisibility(ivec2 pixel) {
  vec3 place = WELKIN_OCCLUSION_POSITION(pixel);
  vec3 view = -normalize(place);
  vec3 normal = WELKIN_OCCLUSION_NORMAL(pixel);
  normal = normalize(normal + view * max(0.01 - dot(normal, view), 0.0));  // an interpolated one may turn away
  vec3 axis = normalize(cross(view, abs(view.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
  vec3 projected = WELKIN_OCCLUSION_PROJECT(place);
  float offset = stepOffset(pixel.x, pixel.y);
  float open = 0.0;
  float found = 0.0;
  for (int slice = 0; slice < WELKIN_OCCLUSION_SLICES; ++slice) {
    float turn = kPi * (float(slice) + sliceTurn(pixel.x, pixel.y)) / float(WELKIN_OCCLUSION_SLICES);
    vec3 tangent = axis * cos(turn) + cross(view, axis) * sin(turn);
    vec3 across = cross(view, tangent);
    vec2 n = vec2(dot(normal, view), dot(normal, tangent));
    // A sample's pixel lies beside the slice. It is moved into it along the surface, so that a plane stays a plane.
    vec2 skew = n * (dot(normal, across) / dot(n, n));
    vec3 along_view = view + across * skew.x;
    vec3 along_tangent = tangent + across * skew.y;
    vec3 way = WELKIN_OCCLUSION_PROJECT(tangent);
    float nearest_m = projected.z / length(way.xy - way.z * projected.xy / projected.z);  // a pixel away
    float span_m = max(WELKIN_OCCLUSION_RADIUS_M - nearest_m, 0.0);
    vec2 highest = vec2(-1.0);  // cosine of the horizon's angle from the view, against and along the tangent
    for (int i = 0; i < 2 * WELKIN_OCCLUSION_STEPS; ++i) {
      float share = (float(i >> 1) + offset) / float(WELKIN_OCCLUSION_STEPS);
      float reach_m = nearest_m + span_m * share * share;
      vec3 at = projected + way * ((i & 1) == 0 ? reach_m : -reach_m);
      ivec2 there = ivec2(floor(at.xy / max(at.z, 1e-6)));
      bool inside = at.z > 0.0 && all(greaterThanEqual(there, ivec2(0))) && all(lessThan(there, WELKIN_OCCLUSION_SIZE));
      vec3 away = WELKIN_OCCLUSION_POSITION(inside ? there : pixel) - place;
      float squared_m = dot(away, away);
      bool blocks = squared_m < WELKIN_OCCLUSION_RADIUS_M * WELKIN_OCCLUSION_RADIUS_M &&
                    dot(away, normal) > kOcclusionFlat * sqrt(squared_m);
      vec2 front = vec2(dot(away, along_view), dot(away, along_tangent));
      float cosine = blocks ? front.x * inversesqrt(dot(front, front)) : -1.0;
      highest = max(highest, front.y < 0.0 ? vec2(cosine, -1.0) : vec2(-1.0, cosine));
    }
    float gamma = atan(n.y, n.x);
    open += length(n) * sliceLight(-1.0, -1.0, gamma);
    found += length(n) * sliceLight(highest.x, highest.y, gamma);
  }
  return found / open;
}

#endif
