// SPDX-License-Identifier: Apache-2.0
// The three textures of a volume, its far map, its buffer of cuts, and the descriptor sets that read them.
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
  VkImage images[5] = {};
  /// The three textures, or for a volume that the device fills its words and then them; then the far map.
  VkImageView views[5] = {};
  uint32_t far_edge = 0;  ///< texels of the far map along x and z
  WelkinVulkanAllocation image_memory{};
  VkDeviceSize image_bytes = 0;
  welkin::vulkan::MappedBuffer staging;  ///< of each frame: its constants, then the words and texels that it copies
  welkin::vulkan::LocalBuffer cuts;      ///< welkin_volume_cuts
  VkDeviceSize cut_bytes = 0;            ///< of its words
  VkDeviceSize constants_bytes = 0;      ///< room for a frame's constants
  VkDeviceSize frame_bytes = 0;
  uint32_t frame_count = 0;
  VkSampler sampler = VK_NULL_HANDLE;
  welkin::vulkan::FrameSets sets;
  bool recorded = false;                  ///< the images that updates copy to have their texels
  bool far_recorded = false;              ///< the far map has its texels
  welkin::vulkan::VolumeRelight relight;  ///< for WELKIN_VOLUME_DEVICE

  bool relights() const { return copied == 1; }
  /// First of the three textures among the images.
  uint32_t textures() const { return relights() ? 1 : 0; }
  uint32_t farMap() const { return textures() + 3; }
  VkDeviceSize farBytes() const { return VkDeviceSize{4} * far_edge * far_edge; }
  /// Where a frame's parts begin in its staging memory: words, the far map's texels, texels.
  VkDeviceSize cutStaging() const { return constants_bytes; }
  VkDeviceSize farStaging() const { return cutStaging() + cut_bytes; }
  VkDeviceSize texelStaging() const { return farStaging() + farBytes(); }
  welkin::vulkan::RelightImages relightImages() const {
    return {{images[1], images[2], images[3]}, {views[1], views[2], views[3]}, views[0], extent};
  }
};

namespace welkin::vulkan {

/// Creates images, buffers and sets. `o` has the device, extent, slices, format, far_edge, cut_bytes and
/// frame_count.
WelkinResult createVolumeImages(WelkinVulkanVolume& o, WelkinMessage* message);
void destroy(WelkinVulkanVolume& o);

}  // namespace welkin::vulkan
