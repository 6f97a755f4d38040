// SPDX-License-Identifier: Apache-2.0
// Relights the probes of a volume of WELKIN_VOLUME_DEVICE and fills its textures by two compute passes.
#pragma once

#include "probes/volume.h"
#include "vulkan/frame_sets.h"
#include "vulkan/memory.h"

namespace welkin::vulkan {

/// The sector that a slot of the device's memory holds.
struct RelightSlot {
  const WelkinSector* sector = nullptr;  ///< null: free
  uint64_t arrival = 0;
  uint64_t fixed_changes = 0;
};

struct VolumeRelight {
  uint32_t slots = 0;
  VkDeviceSize light_bytes = 0;  ///< of a frame's VolumeLight and SlotLights
  VkDeviceSize frame_bytes = 0;  ///< of a frame's staging: those, then a room for every slot
  MappedBuffer staging;
  LocalBuffer probes;  ///< the slots
  LocalBuffer relit;   ///< irradiance: probe, channel, direction
  FrameSets sets;
  VkPipelineLayout pipeline_layout = VK_NULL_HANDLE;
  VkPipeline pipelines[2] = {};  ///< relight, fill
  RelightSlot* slot = nullptr;
  uint64_t instant = 0;  ///< WelkinLevel::instant that the textures show
  float scale = 0.0F;    ///< likewise the volume's
  std::array<float, probes::kColours> open{};
  bool is_filled = false;  ///< the textures have texels
};

/// Textures that the passes write, and the words that lead them.
struct RelightImages {
  VkImage texels[3];
  VkImageView texel_views[3];
  VkImageView words;
  VkExtent3D extent;
};

/// Creates buffers, sets and pipelines for a volume.
WelkinResult createRelight(const Device& device, const WelkinVolume& volume, const RelightImages& images,
                           uint32_t frames, VkPipelineCache cache, VolumeRelight& o, WelkinMessage* message);
void destroy(const Device& device, VolumeRelight& o);

/// Records both passes, unless the textures show the present light. `words_changed`: since the last call.
void recordRelight(const Device& device, VolumeRelight& o, const RelightImages& images, const WelkinVolume& volume,
                   VkCommandBuffer commands, uint32_t frame, bool words_changed);

}  // namespace welkin::vulkan
