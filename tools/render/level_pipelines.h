// SPDX-License-Identifier: Apache-2.0
// The pipelines of the level picture, their layout and samplers.
#pragma once

#include "render/shaders/level_constants.h"
#include "render/vulkan_device.h"

namespace welkin::render {

class LevelPipelines {
 public:
  static constexpr VkFormat kDepthFormat = VK_FORMAT_D32_SFLOAT;
  static constexpr VkFormat kSurfaceFormat = VK_FORMAT_R16G16B16A16_SFLOAT;  ///< albedo, normal

  /// `sky` is the layout of set 0, and `volume` that of set 2, or VK_NULL_HANDLE without probes; `reflection` is that
  /// of the set after the others. With `light_of_modes` the open sky's light comes from the modes of its irradiance.
  LevelPipelines(const VulkanDevice& device, VkDescriptorSetLayout sky, VkDescriptorSetLayout volume,
                 VkDescriptorSetLayout reflection, bool light_of_modes);
  ~LevelPipelines() { destroy(); }
  LevelPipelines(const LevelPipelines&) = delete;
  LevelPipelines& operator=(const LevelPipelines&) = delete;

  VkDescriptorSetLayout setLayout() const { return set_; }
  VkPipelineLayout layout() const { return layout_; }
  VkSampler shadowSampler() const { return shadow_sampler_; }
  VkSampler sampler() const { return sampler_; }

  VkPipeline shadow = VK_NULL_HANDLE;   ///< depth alone
  VkPipeline surface = VK_NULL_HANDLE;  ///< albedo, normal and emission
  VkPipeline light = VK_NULL_HANDLE;    ///< radiance where there is a surface
  VkPipeline glossy = VK_NULL_HANDLE;   ///< likewise, of materials that reflect the sky
  VkPipeline place = VK_NULL_HANDLE;    ///< normal and distance where there is a surface
  VkPipeline probes = VK_NULL_HANDLE;   ///< radiance and depth of the spheres of probes
  VkPipeline glass = VK_NULL_HANDLE;    ///< radiance of surfaces that light passes, over what is there
  VkPipeline water = VK_NULL_HANDLE;    ///< radiance of the sea, where nothing is in front of it

 private:
  void createLayouts(VkDescriptorSetLayout sky, VkDescriptorSetLayout volume, VkDescriptorSetLayout reflection);
  void createSamplers();
  void createPipelines(bool light_of_modes, bool of_probes);
  void destroy();

  VkDevice device_;
  VkDescriptorSetLayout set_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkSampler shadow_sampler_ = VK_NULL_HANDLE;
  VkSampler sampler_ = VK_NULL_HANDLE;
};

}  // namespace welkin::render
