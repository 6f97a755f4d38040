// SPDX-License-Identifier: Apache-2.0
// Device memory, the library's or the caller's: mapped buffers, and one block for all images.
#pragma once

#include "vulkan/device.h"

namespace welkin::vulkan {

/// A buffer in host-visible, coherent memory, mapped as long as it lives.
struct MappedBuffer {
  VkBuffer buffer = VK_NULL_HANDLE;
  WelkinVulkanAllocation allocation{};
  VkDeviceSize bytes = 0;  ///< allocated
  unsigned char* mapped = nullptr;
};

WelkinResult createMapped(const Device& device, VkDeviceSize bytes, VkBufferUsageFlags usage, const char* name,
                          MappedBuffer& buffer, WelkinMessage* message);
void destroy(const Device& device, MappedBuffer& buffer);

/// A sampled image: gradient (1 layer), cubemap (6) or an array of layers.
struct Image {
  VkImage image = VK_NULL_HANDLE;
  VkImageView view = VK_NULL_HANDLE;
  VkExtent2D extent{};
  uint32_t layers = 0;
  bool is_array = false;  ///< read as an array, also when it has one layer
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkDeviceSize texel_bytes = 0;
  VkDeviceSize staging_offset = 0;
  uint32_t mips = 1;
  bool blits_mips = true;  ///< the device makes the mips after the first; else they are staged too
  bool borrowed = false;   ///< the caller's image

  /// Bytes of one mip, all its layers.
  VkDeviceSize mipBytes(uint32_t mip) const {
    return texel_bytes * edgeAt(extent.width, mip) * edgeAt(extent.height, mip) * layers;
  }
  uint32_t stagedMips() const { return blits_mips ? 1 : mips; }
  /// Bytes of the mips that are staged, one after the other.
  VkDeviceSize stagedBytes() const {
    VkDeviceSize sum = 0;
    for (uint32_t mip = 0; mip < stagedMips(); ++mip) sum += mipBytes(mip);
    return sum;
  }
  static uint32_t edgeAt(uint32_t edge, uint32_t mip) { return edge >> mip > 0 ? edge >> mip : 1; }
};

/// Mips of a square of `edge` texels down to one.
uint32_t mipCount(uint32_t edge);

/// The request to vkCreateImage.
VkImageCreateInfo imageInfo(const Image& image);

/// Creates the images that are not borrowed, their memory as one allocation, and the views of all.
WelkinResult createImages(const Device& device, Image* images, uint32_t count, WelkinVulkanAllocation& allocation,
                          VkDeviceSize& memory_bytes, WelkinMessage* message);
void destroy(const Device& device, Image& image);
void freeMemory(const Device& device, WelkinVulkanAllocation& allocation);

/// Records the copy of every image from `staging` and fills the mips that are not there, each from the one before by a
/// linear blit; leaves them in VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL.
void recordImageUpload(const Device& device, VkCommandBuffer commands, VkBuffer staging, const Image* images,
                       uint32_t count);

}  // namespace welkin::vulkan
