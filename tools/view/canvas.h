// SPDX-License-Identifier: Apache-2.0
// A picture on the device with panels over it.
#pragma once

#include <memory>

#include "render/tone.h"
#include "view/panel_pipeline.h"

namespace welkin::view {

class Canvas {
 public:
  static constexpr VkFormat kFormat = VK_FORMAT_R8G8B8A8_UNORM;

  /// Needs a current ImGui context.
  explicit Canvas(render::VulkanDevice& device);

  /// Records the picture, stretched to the size, and the panels over it.
  void record(VkCommandBuffer commands, const render::Picture& picture, uint32_t width, uint32_t height,
              const ImDrawData& panels);
  /// What was recorded last; not before the first record().
  render::Image& image() { return *image_; }

  /// Draws the same and reads it back.
  render::Picture read(const render::Picture& picture, uint32_t width, uint32_t height, const ImDrawData& panels);

 private:
  void resize(uint32_t width, uint32_t height, uint32_t picture_width, uint32_t picture_height);

  render::VulkanDevice& device_;
  PanelPipeline panels_;
  std::unique_ptr<render::Image> image_, picture_;
  std::unique_ptr<render::Buffer> staging_;  ///< of the picture
};

}  // namespace welkin::view
