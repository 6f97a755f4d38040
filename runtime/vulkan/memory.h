// SPDX-License-Identifier: Apache-2.0
// Device memory: mapped buffers, and one block for all images.
#pragma once

#include "vulkan/device.h"

namespace welkin::vulkan {

/// A buffer in host-visible, coherent memory, mapped as long as it lives.
struct MappedBuffer {
  VkBuffer buffer = VK_NULL_HANDLE;
  VkDeviceMemory memory = VK_NULL_HANDLE;
  VkDeviceSize bytes = 0;  ///< allocated
  unsigned char* mapped = nullptr;
};

WelkinResult createMapped(const Device& device, VkDeviceSize bytes, VkBufferUsageFlags usage, const char* name,
                          MappedBuffer& buffer, WelkinMessage* message);
void destroy(const Device& device, MappedBuffer& buffer);

/// A sampled image: gradient (1 layer) or cubemap (6).
struct Image {
  VkImage image = VK_NULL_HANDLE;
  VkImageView view = VK_NULL_HANDLE;
  VkExtent2D extent{};
  uint32_t layers = 0;
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkDeviceSize texel_bytes = 0;
  VkDeviceSize staging_offset = 0;

  VkDeviceSize bytes() const { return texel_bytes * extent.width * extent.height * layers; }
};

/// Creates the images from extent, layers, format, their memory as one allocation, and their views.
WelkinResult createImages(const Device& device, Image* images, uint32_t count, VkDeviceMemory& memory,
                          VkDeviceSize& memory_bytes, WelkinMessage* message);
void destroy(const Device& device, Image& image);

/// Records the copy of every image from `staging`; leaves them in VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL.
void recordImageUpload(const Device& device, VkCommandBuffer commands, VkBuffer staging, const Image* images,
                       uint32_t count);

}  // namespace welkin::vulkan
