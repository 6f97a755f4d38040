// SPDX-License-Identifier: Apache-2.0
// The occlusion over a G-buffer in a storage buffer, which shows that any layout will do. PASS is 0 for
// reading the G-buffer alone, 1 for the visibility, 2 for its denoising.
#version 460
#extension GL_GOOGLE_include_directive : require

struct Pixel {
  vec4 place;   // xyz: from the camera, metres; w: visibility found
  vec4 normal;
};

layout(local_size_x = 64) in;
layout(set = 0, binding = 0, std430) readonly buffer Pixels {
  vec4 projection[3];
  ivec4 size;
  Pixel pixels[];
};
layout(set = 0, binding = 1, std430) writeonly buffer Results { float results[]; };

uint at(ivec2 pixel) { return uint(pixel.y * size.x + pixel.x); }
vec3 placeAt(ivec2 pixel) { return pixels[at(pixel)].place.xyz; }
vec3 normalAt(ivec2 pixel) { return pixels[at(pixel)].normal.xyz; }
float noisyAt(ivec2 pixel) { return pixels[at(pixel)].place.w; }
vec3 project(vec3 p) { return vec3(dot(projection[0].xyz, p), dot(projection[1].xyz, p), dot(projection[2].xyz, p)); }

#define WELKIN_OCCLUSION_POSITION placeAt
#define WELKIN_OCCLUSION_NORMAL normalAt
#define WELKIN_OCCLUSION_PROJECT project
#define WELKIN_OCCLUSION_SIZE size.xy
#define WELKIN_OCCLUSION_NOISY noisyAt
#include "welkin/occlusion_denoise.glsl"

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= uint(results.length())) return;
  ivec2 pixel = ivec2(int(i) % size.x, int(i) / size.x);
#if PASS == 0
  results[i] = dot(placeAt(pixel), normalAt(pixel));
#elif PASS == 1
  results[i] = welkinOcclusionVisibility(pixel);
#else
  results[i] = welkinOcclusionDenoised(pixel);
#endif
}
