// SPDX-License-Identifier: Apache-2.0
// Creates and records the sphere picture's pipeline.
#include "render/sphere_pipeline.h"

#include <cstdint>

#include "render/graphics_pipeline.h"
#include "spirv/kFullscreenVert.h"
#include "spirv/kSpheresFrag.h"
#include "spirv/kSpheresOfModesFrag.h"

namespace welkin::render {

SpherePipeline::SpherePipeline(const VulkanDevice& device, VkDescriptorSetLayout sky, VkFormat colour_format,
                               bool light_of_modes)
    : device_(device.device()) {
  const VkPushConstantRange range{VK_SHADER_STAGE_FRAGMENT_BIT, 0, sizeof(render::shaders::SpheresPush)};
  VkPipelineLayoutCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  info.setLayoutCount = 1;
  info.pSetLayouts = &sky;
  info.pushConstantRangeCount = 1;
  info.pPushConstantRanges = &range;
  require(vkCreatePipelineLayout(device_, &info, nullptr, &layout_), "vkCreatePipelineLayout");
  using Words = std::span<const uint32_t>;
  pipeline_ =
      createGraphicsPipeline(device_, {.layout = layout_,
                                       .vertex = kFullscreenVert,
                                       .fragment = light_of_modes ? Words(kSpheresOfModesFrag) : Words(kSpheresFrag),
                                       .colours = {colour_format}});
}

SpherePipeline::~SpherePipeline() {
  vkDestroyPipeline(device_, pipeline_, nullptr);
  vkDestroyPipelineLayout(device_, layout_, nullptr);
}

void SpherePipeline::record(VkCommandBuffer commands, VkDescriptorSet sky,
                            const render::shaders::SpheresPush& push) const {
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_);
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 1, &sky, 0, nullptr);
  vkCmdPushConstants(commands, layout_, VK_SHADER_STAGE_FRAGMENT_BIT, 0, sizeof(push), &push);
  vkCmdDraw(commands, 3, 1, 0, 0);
}

}  // namespace welkin::render
