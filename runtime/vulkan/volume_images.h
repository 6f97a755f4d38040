// SPDX-License-Identifier: Apache-2.0
// The three textures of a volume, its buffer of cuts, and the descriptor sets that read them.
#pragma once

#include <welkin/welkin_vulkan_volume.h>

#include "vulkan/frame_sets.h"
#include "vulkan/memory.h"
#include "vulkan/volume_relight.h"

struct WelkinVulkanVolume {
  welkin::vulkan::Device device;
  VkExtent3D extent{};
  uint32_t slices = 0;  ///< of the volume itself, without bricks
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkDeviceSize texel_bytes = 0;
  uint32_t copied = 3;  ///< images that updates copy texels to: the first of `images`
  VkImage images[4] = {};
  VkImageView views[4] = {};  ///< the three textures, or for a volume that the device fills its words and then them
  WelkinVulkanAllocation image_memory{};
  VkDeviceSize image_bytes = 0;
  welkin::vulkan::MappedBuffer staging;  ///< of each frame: its constants, then the texels that it copies
  welkin::vulkan::LocalBuffer cuts;      ///< welkin_volume_cuts
  VkDeviceSize cut_bytes = 0;            ///< of its words
  VkDeviceSize constants_bytes = 0;      ///< room for a frame's constants
  VkDeviceSize frame_bytes = 0;
  uint32_t frame_count = 0;
  VkSampler sampler = VK_NULL_HANDLE;
  welkin::vulkan::FrameSets sets;
  bool recorded = false;                  ///< the images that updates copy to have their texels
  welkin::vulkan::VolumeRelight relight;  ///< for WELKIN_VOLUME_DEVICE

  bool relights() const { return copied == 1; }
  /// First of the three textures among the images.
  uint32_t textures() const { return relights() ? 1 : 0; }
  welkin::vulkan::RelightImages relightImages() const {
    return {{images[1], images[2], images[3]}, {views[1], views[2], views[3]}, views[0], extent};
  }
};

namespace welkin::vulkan {

/// Creates images, buffers and sets. `o` has the device, extent, slices, format, cut_bytes and frame_count.
WelkinResult createVolumeImages(WelkinVulkanVolume& o, WelkinMessage* message);
void destroy(WelkinVulkanVolume& o);

}  // namespace welkin::vulkan
