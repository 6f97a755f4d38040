#version 460
// SPDX-License-Identifier: Apache-2.0
// Fills the volume's texels, each with the light of the probe that its word names.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require
#include "volume_relight.h"

layout(local_size_x = 8, local_size_y = 4, local_size_z = 2) in;
layout(set = 0, binding = 2, std430) readonly buffer Relit { vec4 relit[]; };  // probe, channel
layout(set = 0, binding = 3) uniform utexture3D words;  // 0: open; 1: dark; else 2 more than a probe
layout(set = 0, binding = 4, rgba16f) uniform writeonly image3D texels[3];

const float kLargestHalf = 65504.0;

vec4 texelOf(uint word, uint c) {
  vec4 value = vec4(0.0);
  if (word == 0)
    value = vec4(light.volume.open[4 * c], light.volume.open[4 * c + 1], light.volume.open[4 * c + 2],
                 light.volume.open[4 * c + 3]);
  if (word > 1) value = relit[3 * (word - 2) + c];
  return clamp(value * light.volume.inverse_scale, -kLargestHalf, kLargestHalf);
}

void main() {
  ivec3 at = ivec3(gl_GlobalInvocationID);
  if (any(greaterThanEqual(at, imageSize(texels[0])))) return;
  uint word = texelFetch(words, at, 0).x;
  imageStore(texels[0], at, texelOf(word, 0));
  imageStore(texels[1], at, texelOf(word, 1));
  imageStore(texels[2], at, texelOf(word, 2));
}
