// SPDX-License-Identifier: Apache-2.0
// A host-visible, coherent, mapped Vulkan buffer.
#pragma once

#include "render/vulkan_device.h"

namespace welkin::render {

class Buffer {
 public:
  Buffer(const VulkanDevice& device, VkDeviceSize bytes, VkBufferUsageFlags usage);
  ~Buffer();
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  VkBuffer handle() const { return buffer_; }
  VkDeviceSize bytes() const { return bytes_; }
  template <typename T>
  T* as() const {
    return static_cast<T*>(mapped_);
  }

 private:
  VkDevice device_;
  VkDeviceSize bytes_;
  VkBuffer buffer_ = VK_NULL_HANDLE;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
  void* mapped_ = nullptr;
};

/// Records a barrier after which the host may read the bytes that `stage` has written by `access`.
void recordHostRead(VkCommandBuffer commands, VkPipelineStageFlags2 stage, VkAccessFlags2 access);

}  // namespace welkin::render
