// SPDX-License-Identifier: Apache-2.0
// The light of an instant and the probes of the sectors, as the passes that relight a volume read them; C++ and GLSL.
// A slot holds a sector's probes: blocks of eight as runtime/probes/packed_probes.h lays them out, and from
// WELKIN_SLOT_FIXED on the light that does not follow the day, a float for each probe, channel and direction.
#ifndef WELKIN_VOLUME_RELIGHT_H
#define WELKIN_VOLUME_RELIGHT_H

// Bytes of a block's parts, from its start. The scales come first.
#define WELKIN_BLOCK_VISIBILITY 64
#define WELKIN_BLOCK_SKY 112
#define WELKIN_BLOCK_SIDE 304
#define WELKIN_BLOCK_SUN 496

#define WELKIN_SLOT_PROBES 256
#define WELKIN_SLOT_FIXED (32 * (WELKIN_BLOCK_SUN + 32 * 16) / 4)  // words of 32 blocks of 16 modes
#define WELKIN_SLOT_WORDS (WELKIN_SLOT_FIXED + 12 * WELKIN_SLOT_PROBES)

#ifdef __cplusplus
#include <cstdint>
namespace welkin::passes {
using uint = uint32_t;
#endif

// The light of one sector, in steps of its numbers.
struct SlotLight {
  float open[9];   // upper direction, channel
  float sky[12];   // coefficient, channel
  float mode[96];  // light, mode of 16, channel
  float local;     // factor on the light that does not follow the day
  uint lights;     // that are up
  uint modes;
  uint probes;    // 0: the slot is free
  uint is_fixed;  // 1: it has light that does not follow the day
};

// What comes before the lights of the slots.
struct VolumeLight {
  float open[12];       // beyond the sectors: channel, direction
  float inverse_scale;  // of the texels
  uint slots;
  uint pad[2];
};

#ifdef __cplusplus
static_assert(sizeof(SlotLight) == 4 * 122 && sizeof(VolumeLight) == 64);
}  // namespace welkin::passes
#else
layout(set = 0, binding = 0, std430) readonly buffer Light {
  VolumeLight volume;
  SlotLight slot[];
}
light;
#endif

#endif
