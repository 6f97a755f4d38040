// SPDX-License-Identifier: Apache-2.0
// Draws Dear ImGui's triangles. Debian's ImGui 1.86 has a Vulkan backend, but it needs render passes and links Vulkan.
#pragma once

#include <memory>

#include "render/float_texture.h"

struct ImDrawData;

namespace welkin::view {

class PanelPipeline {
 public:
  /// Makes the font's texture of the current ImGui context. Draws into images of this format.
  PanelPipeline(render::VulkanDevice& device, VkFormat format);
  ~PanelPipeline() { destroy(); }
  PanelPipeline(const PanelPipeline&) = delete;
  PanelPipeline& operator=(const PanelPipeline&) = delete;

  /// Records the panels over an image of their size. The buffers live until the next call.
  void record(VkCommandBuffer commands, render::Image& over, const ImDrawData& panels);

 private:
  void createLayout();
  void createSet();
  void upload(const ImDrawData& panels);
  void destroy();

  render::VulkanDevice& device_;
  std::unique_ptr<render::FloatTexture> font_;
  VkDescriptorSetLayout set_layout_ = VK_NULL_HANDLE;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
  std::unique_ptr<render::Buffer> vertices_, indices_;
};

}  // namespace welkin::view
