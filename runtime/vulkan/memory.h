// SPDX-License-Identifier: Apache-2.0
// Device memory from the library or the caller: mapped buffers, and one block for all images.
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

/// A buffer in memory of the device, where it can be, that no host sees.
struct LocalBuffer {
  VkBuffer buffer = VK_NULL_HANDLE;
  WelkinVulkanAllocation allocation{};
  VkDeviceSize bytes = 0;  ///< allocated
};

WelkinResult createLocal(const Device& device, VkDeviceSize bytes, VkBufferUsageFlags usage, const char* name,
                         LocalBuffer& buffer, WelkinMessage* message);
void destroy(const Device& device, LocalBuffer& buffer);

/// A sampled image: a map (1 layer), a cubemap (6 layers) or an array of layers.
struct Image {
  VkImage image = VK_NULL_HANDLE;
  VkImageView view = VK_NULL_HANDLE;
  VkExtent2D extent{};
  uint32_t layers = 0;
  bool is_array = false;  ///< shaders read it as an array, even if it has one layer
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkDeviceSize texel_bytes = 0;
  VkDeviceSize staging_offset = 0;
  uint32_t mips = 1;
  bool blits_mips = true;  ///< true: blits make the mips after the first; false: they are staged too
  bool borrowed = false;   ///< the image belongs to the caller

  /// Bytes of all layers of one mip.
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

/// Number of mips from a square with `edge` texels along an edge down to one texel.
uint32_t mipCount(uint32_t edge);

/// The request to vkCreateImage.
VkImageCreateInfo imageInfo(const Image& image);

/// Creates the images that are not borrowed, their memory as one allocation, and the views of all.
WelkinResult createImages(const Device& device, Image* images, uint32_t count, WelkinVulkanAllocation& allocation,
                          VkDeviceSize& memory_bytes, WelkinMessage* message);
/// Device memory for images that need `block`, local to the device where it can be.
WelkinResult allocateImages(const Device& device, const VkMemoryRequirements& block, const char* name,
                            WelkinVulkanAllocation& allocation, WelkinMessage* message);
void destroy(const Device& device, Image& image);
void freeMemory(const Device& device, WelkinVulkanAllocation& allocation);

/// Records the copy of every image from `staging`. Mips that are not staged are filled by linear blits, each from the
/// mip before. Leaves the images in VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL.
void recordImageUpload(const Device& device, VkCommandBuffer commands, VkBuffer staging, const Image* images,
                       uint32_t count);

}  // namespace welkin::vulkan
