#version 460
// SPDX-License-Identifier: Apache-2.0
// Irradiance of the probes of all slots in the four directions, as relightProbes computes it on the CPU: one invocation
// a probe and direction.
#extension GL_GOOGLE_include_directive : require
#include "volume_relight.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = 1, std430) readonly buffer Probes { uint word[]; };
layout(set = 0, binding = 2, std430) writeonly buffer Relit { float relit[]; };  // probe, channel, direction

uint unsignedAt(uint at, uint bits) { return bitfieldExtract(word[at >> 2], int(8 * (at & 3)), int(bits)); }
float byteAt(uint at) { return float(unsignedAt(at, 8)); }
float signedAt(uint at) { return float(bitfieldExtract(int(word[at >> 2]), int(8 * (at & 3)), 8)); }

void main() {
  uint b = gl_GlobalInvocationID.x & 3, p = gl_GlobalInvocationID.x >> 2 & 255, s = gl_GlobalInvocationID.x >> 10;
  if (s >= light.volume.slots || p >= light.slot[s].probes) return;
  uint modes = light.slot[s].modes;
  uint start = 4 * WELKIN_SLOT_WORDS * s, lane = p & 7;
  uint block = start + (p >> 3) * (WELKIN_BLOCK_SUN + 32 * modes);
  float channel[3];
  for (uint c = 0; c < 3; ++c) {
    float sum = 0.0;
    for (uint k = 0; k < 2; ++k) {
      uint at = (6 * b + 3 * k + c) * 8 + lane;
      sum += byteAt(block + WELKIN_BLOCK_SKY + at) * light.slot[s].sky[3 * k + c];
      sum += signedAt(block + WELKIN_BLOCK_SIDE + at) * light.slot[s].sky[3 * (2 + k) + c];
    }
    sum *= uintBitsToFloat(word[(block >> 2) + lane]);
    if (b < 3)
      sum += float(unsignedAt(block + WELKIN_BLOCK_VISIBILITY + 2 * (b * 8 + lane), 16)) * light.slot[s].open[3 * b + c];
    channel[c] = sum;
  }
  float of_sun = uintBitsToFloat(word[(block >> 2) + 8 + lane]);
  for (uint i = 0; i < light.slot[s].lights; ++i) {
    vec3 sun = vec3(0.0);
    for (uint m = 0; m < modes; ++m) {
      uint at = 3 * (16 * i + m);
      sun += signedAt(block + WELKIN_BLOCK_SUN + (b * modes + m) * 8 + lane) *
             vec3(light.slot[s].mode[at], light.slot[s].mode[at + 1], light.slot[s].mode[at + 2]);
    }
    for (uint c = 0; c < 3; ++c) channel[c] += of_sun * max(sun[c], 0.0);
  }
  uint fixed_at = WELKIN_SLOT_WORDS * s + WELKIN_SLOT_FIXED + 12 * p + b;
  for (uint c = 0; c < 3; ++c) {
    float always = light.slot[s].is_fixed != 0 ? light.slot[s].local * uintBitsToFloat(word[fixed_at + 4 * c]) : 0.0;
    relit[(256 * s + p) * 12 + 4 * c + b] = channel[c] + always;
  }
}
