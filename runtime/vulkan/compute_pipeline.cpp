// SPDX-License-Identifier: Apache-2.0
#include "vulkan/compute_pipeline.h"

namespace welkin::vulkan {

WelkinResult createComputePipeline(const Device& device, std::span<const uint32_t> words, VkPipelineCache cache,
                                   const char* name, VkPipelineLayout layout, VkPipeline& pipeline,
                                   WelkinMessage* message) {
  VkShaderModuleCreateInfo code{};
  code.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
  code.codeSize = words.size_bytes();
  code.pCode = words.data();
  VkComputePipelineCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
  info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  info.stage.pName = "main";
  info.layout = layout;
  if (const auto r = check(device.fn.CreateShaderModule(device.handle, &code, device.allocator, &info.stage.module),
                           "vkCreateShaderModule", message))
    return r;
  const VkResult result = device.fn.CreateComputePipelines(device.handle, cache, 1, &info, device.allocator, &pipeline);
  device.fn.DestroyShaderModule(device.handle, info.stage.module, device.allocator);
  if (const auto r = check(result, "vkCreateComputePipelines", message)) return r;
  device.name(VK_OBJECT_TYPE_PIPELINE, pipeline, name);
  return WELKIN_OK;
}

}  // namespace welkin::vulkan
