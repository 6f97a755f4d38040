// SPDX-License-Identifier: Apache-2.0
// Averages the noise of occlusion.glsl: one pass over its result.
//   welkinOcclusionDenoised(pixel)  visibility in [0, 1]: the mean over 4 x 4 pixels, of which each has another turn
// Pixels count that lie in the plane of the surface at the middle one.
//
// Needs what occlusion.glsl needs, and
//   float WELKIN_OCCLUSION_NOISY(ivec2 pixel)  the result of welkinOcclusionVisibility there
#ifndef WELKIN_OCCLUSION_DENOISE_GLSL
#define WELKIN_OCCLUSION_DENOISE_GLSL

#ifndef WELKIN_OCCLUSION_NOISY
#error WELKIN_OCCLUSION_NOISY is not defined: a function of a pixel that gives the visibility found there
#endif

#include "occlusion.glsl"

// Largest distance from the plane, as a share of the distance from the camera.
const float kOcclusionPlane = 0.005;

float welkinOcclusionDenoised(ivec2 pixel) {
  vec3 place = WELKIN_OCCLUSION_POSITION(pixel);
  vec3 normal = WELKIN_OCCLUSION_NORMAL(pixel);
  float farthest_m = kOcclusionPlane * length(place);
  float sum = 0.0;
  float weight = 0.0;
  for (int i = 0; i < 16; ++i) {
    ivec2 there = pixel + ivec2(i & 3, i >> 2) - 2;
    bool inside = all(greaterThanEqual(there, ivec2(0))) && all(lessThan(there, WELKIN_OCCLUSION_SIZE));
    there = inside ? there : pixel;
    float off_m = abs(dot(WELKIN_OCCLUSION_POSITION(there) - place, normal));
    float counts = float(inside && off_m <= farthest_m);
    sum += counts * WELKIN_OCCLUSION_NOISY(there);
    weight += counts;
  }
  return sum / max(weight, 1.0);
}

#endif
