// SPDX-License-Identifier: Apache-2.0
// The pipeline of the sphere picture. It uses the sky's descriptor set as a game's own pass would.
#pragma once

#include "render/shaders/spheres_push.h"
#include "render/vulkan_device.h"

namespace welkin::render {

class SpherePipeline {
 public:
  /// With `light_of_modes` the ambient light comes from the modes of the sky's irradiance.
  SpherePipeline(const VulkanDevice& device, VkDescriptorSetLayout sky, VkFormat colour_format, bool light_of_modes);
  ~SpherePipeline();
  SpherePipeline(const SpherePipeline&) = delete;
  SpherePipeline& operator=(const SpherePipeline&) = delete;

  void record(VkCommandBuffer commands, VkDescriptorSet sky, const render::shaders::SpheresPush& push) const;

 private:
  VkDevice device_;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
};

}  // namespace welkin::render
