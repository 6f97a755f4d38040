// SPDX-License-Identifier: Apache-2.0
// An RGBA 32-bit float image to draw into, and its way back to the host.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "render/buffer.h"

namespace welkin::tools {

/// Radiance, rows from the top, four floats a pixel.
struct FloatImage {
  uint32_t width = 0;
  uint32_t height = 0;
  std::vector<float> rgba;

  const float* pixel(uint32_t x, uint32_t y) const { return rgba.data() + 4 * (std::size_t{y} * width + x); }
};

class Offscreen {
 public:
  static constexpr VkFormat kFormat = VK_FORMAT_R32G32B32A32_SFLOAT;

  /// Throws Error(usage) when the device has no image of that size.
  Offscreen(VulkanDevice& device, uint32_t width, uint32_t height);
  ~Offscreen();
  Offscreen(const Offscreen&) = delete;
  Offscreen& operator=(const Offscreen&) = delete;

  /// Clears to 0, calls `draw` inside dynamic rendering with viewport and scissor set, waits and reads back.
  FloatImage render(const std::function<void(VkCommandBuffer)>& draw);

 private:
  void createImage();

  VulkanDevice& device_;
  uint32_t width_;
  uint32_t height_;
  VkImage image_ = VK_NULL_HANDLE;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
  VkImageView view_ = VK_NULL_HANDLE;
  Buffer readback_;
};

}  // namespace welkin::tools
