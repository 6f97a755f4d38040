// SPDX-License-Identifier: Apache-2.0
// The graphics pipelines of the dome: one for each source of radiance, that replaces or blends.
#pragma once

#include "passes/dome_push.h"
#include "vulkan/device.h"

namespace welkin::vulkan {

struct DomePipeline {
  VkPipelineLayout layout = VK_NULL_HANDLE;
  VkPipeline pipelines[4] = {};  ///< indexed by WelkinVulkanSource, plus 2 for the blending ones
  bool blends = false;           ///< whether the colour format lets the latter exist
};

WelkinResult createDomePipeline(const Device& device, const WelkinVulkanCreateInfo& info, VkDescriptorSetLayout set,
                                DomePipeline& dome, WelkinMessage* message);
void destroy(const Device& device, DomePipeline& dome);

void recordDome(const Device& device, const DomePipeline& dome, VkCommandBuffer commands, VkDescriptorSet set,
                WelkinVulkanSource source, float opacity, const passes::DomePush& push);

}  // namespace welkin::vulkan
