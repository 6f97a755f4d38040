// SPDX-License-Identifier: Apache-2.0
// The graphics pipelines of the dome: for each source of radiance, one that replaces the picture and one that blends.
#pragma once

#include "passes/dome_push.h"
#include "vulkan/device.h"

namespace welkin::vulkan {

struct DomePipeline {
  VkPipelineLayout layout = VK_NULL_HANDLE;
  VkPipeline pipelines[4] = {};  ///< index: WelkinVulkanSource, plus 2 for blending
  bool blends = false;           ///< whether the colour format supports blending
};

WelkinResult createDomePipeline(const Device& device, const WelkinVulkanCreateInfo& info, VkDescriptorSetLayout set,
                                DomePipeline& dome, WelkinMessage* message);
void destroy(const Device& device, DomePipeline& dome);

void recordDome(const Device& device, const DomePipeline& dome, VkCommandBuffer commands, VkDescriptorSet set,
                WelkinVulkanSource source, float opacity, const passes::DomePush& push);

}  // namespace welkin::vulkan
