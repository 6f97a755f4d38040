// SPDX-License-Identifier: Apache-2.0
// An RGBA 32-bit float image to draw into and read back on the host.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "render/buffer.h"
#include "render/image.h"

namespace welkin::render {

/// Radiance, rows from the top, four floats per pixel.
struct FloatImage {
  uint32_t width = 0;
  uint32_t height = 0;
  std::vector<float> rgba;

  const float* pixel(uint32_t x, uint32_t y) const { return rgba.data() + 4 * (std::size_t{y} * width + x); }
};

class Offscreen {
 public:
  static constexpr VkFormat kFormat = VK_FORMAT_R32G32B32A32_SFLOAT;

  /// `more` is added to the image's usage. Throws Error(usage) when the device does not support an image of that size.
  Offscreen(VulkanDevice& device, uint32_t width, uint32_t height, VkImageUsageFlags more = 0);

  Image& image() { return image_; }

  /// Clears to 0, calls `draw` inside dynamic rendering with viewport and scissor set, waits and reads back.
  FloatImage render(const std::function<void(VkCommandBuffer)>& draw);

  /// Calls `record`, which must leave the image drawn, then waits and reads back.
  FloatImage read(const std::function<void(VkCommandBuffer)>& record);

 private:
  VulkanDevice& device_;
  Image image_;
  Buffer readback_;
};

/// Begins dynamic rendering over the whole extent, with viewport and scissor set. `depth` may be null.
void beginRendering(VkCommandBuffer commands, VkExtent2D extent, uint32_t colour_count,
                    const VkRenderingAttachmentInfo* colours, const VkRenderingAttachmentInfo* depth);

}  // namespace welkin::render
