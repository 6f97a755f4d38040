// SPDX-License-Identifier: Apache-2.0
// Creates and records the dome's pipelines.
#include "vulkan/dome_pipeline.h"

#include <cstdint>

#include "spirv/kDomeFrag.h"
#include "spirv/kDomeVert.h"

namespace welkin::vulkan {
namespace {

WelkinResult createLayout(const Device& device, VkDescriptorSetLayout set, VkPipelineLayout& layout,
                          WelkinMessage* message) {
  const VkPushConstantRange range{VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                                  sizeof(passes::DomePush)};
  VkPipelineLayoutCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  info.setLayoutCount = 1;
  info.pSetLayouts = &set;
  info.pushConstantRangeCount = 1;
  info.pPushConstantRanges = &range;
  return check(device.fn.CreatePipelineLayout(device.handle, &info, device.allocator, &layout),
               "vkCreatePipelineLayout", message);
}

WelkinResult createModule(const Device& device, const uint32_t* words, size_t bytes, VkShaderModule& module,
                          WelkinMessage* message) {
  VkShaderModuleCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
  info.codeSize = bytes;
  info.pCode = words;
  return check(device.fn.CreateShaderModule(device.handle, &info, device.allocator, &module), "vkCreateShaderModule",
               message);
}

VkPipelineShaderStageCreateInfo stageOf(VkShaderStageFlagBits stage, VkShaderModule module) {
  VkPipelineShaderStageCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  info.stage = stage;
  info.module = module;
  info.pName = "main";
  return info;
}

WelkinResult createPipelines(const Device& device, const WelkinVulkanCreateInfo& create, VkShaderModule vertex,
                             VkShaderModule fragment, DomePipeline& dome, WelkinMessage* message) {
  VkPipelineVertexInputStateCreateInfo input{};
  input.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
  VkPipelineInputAssemblyStateCreateInfo assembly{};
  assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  VkPipelineViewportStateCreateInfo viewport{};
  viewport.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
  viewport.viewportCount = 1;
  viewport.scissorCount = 1;
  VkPipelineRasterizationStateCreateInfo raster{};
  raster.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
  raster.polygonMode = VK_POLYGON_MODE_FILL;
  raster.cullMode = VK_CULL_MODE_NONE;
  raster.lineWidth = 1.0F;
  VkPipelineMultisampleStateCreateInfo samples{};
  samples.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
  samples.rasterizationSamples = create.samples == 0 ? VK_SAMPLE_COUNT_1_BIT : create.samples;
  VkPipelineDepthStencilStateCreateInfo depth{};
  depth.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
  depth.depthTestEnable = create.depth_format != VK_FORMAT_UNDEFINED ? VK_TRUE : VK_FALSE;
  depth.depthCompareOp = create.depth_compare;
  VkPipelineColorBlendAttachmentState attachments[2] = {};
  for (auto& attachment : attachments)
    attachment.colorWriteMask =
        VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
  attachments[1].blendEnable = VK_TRUE;
  attachments[1].srcColorBlendFactor = VK_BLEND_FACTOR_CONSTANT_ALPHA;
  attachments[1].dstColorBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_CONSTANT_ALPHA;
  attachments[1].srcAlphaBlendFactor = VK_BLEND_FACTOR_CONSTANT_ALPHA;
  attachments[1].dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_CONSTANT_ALPHA;
  VkPipelineColorBlendStateCreateInfo blends[2] = {};
  for (int i = 0; i < 2; ++i) {
    blends[i].sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
    blends[i].attachmentCount = 1;
    blends[i].pAttachments = &attachments[i];
  }
  const VkDynamicState states[3] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR,
                                    VK_DYNAMIC_STATE_BLEND_CONSTANTS};
  VkPipelineDynamicStateCreateInfo dynamic{};
  dynamic.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
  dynamic.dynamicStateCount = 3;
  dynamic.pDynamicStates = states;
  VkPipelineRenderingCreateInfo rendering{};
  rendering.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO;
  rendering.colorAttachmentCount = 1;
  rendering.pColorAttachmentFormats = &create.colour_format;
  rendering.depthAttachmentFormat = create.depth_format;
  rendering.stencilAttachmentFormat = create.stencil_format;

  VkPipelineShaderStageCreateInfo stages[4][2];
  VkGraphicsPipelineCreateInfo infos[4] = {};
  const VkBool32 from_cubemaps[2] = {VK_FALSE, VK_TRUE};
  const VkSpecializationMapEntry entry{0, 0, sizeof(VkBool32)};
  VkSpecializationInfo specialization[4];
  const uint32_t count = dome.blends ? 4 : 2;
  for (uint32_t i = 0; i < count; ++i) {
    specialization[i] = {1, &entry, sizeof(VkBool32), &from_cubemaps[i % 2]};
    stages[i][0] = stageOf(VK_SHADER_STAGE_VERTEX_BIT, vertex);
    stages[i][1] = stageOf(VK_SHADER_STAGE_FRAGMENT_BIT, fragment);
    stages[i][1].pSpecializationInfo = &specialization[i];
    infos[i].sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
    infos[i].pNext = &rendering;
    infos[i].stageCount = 2;
    infos[i].pStages = stages[i];
    infos[i].pVertexInputState = &input;
    infos[i].pInputAssemblyState = &assembly;
    infos[i].pViewportState = &viewport;
    infos[i].pRasterizationState = &raster;
    infos[i].pMultisampleState = &samples;
    infos[i].pDepthStencilState = &depth;
    infos[i].pColorBlendState = &blends[i / 2];
    infos[i].pDynamicState = &dynamic;
    infos[i].layout = dome.layout;
  }
  return check(device.fn.CreateGraphicsPipelines(device.handle, create.pipeline_cache, count, infos, device.allocator,
                                                 dome.pipelines),
               "vkCreateGraphicsPipelines", message);
}

}  // namespace

WelkinResult createDomePipeline(const Device& device, const WelkinVulkanCreateInfo& info, VkDescriptorSetLayout set,
                                DomePipeline& dome, WelkinMessage* message) {
  VkFormatProperties format;
  device.fn.GetPhysicalDeviceFormatProperties(device.physical, info.colour_format, &format);
  dome.blends = (format.optimalTilingFeatures & VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT) != 0;
  if (const auto r = createLayout(device, set, dome.layout, message)) return r;
  VkShaderModule vertex = VK_NULL_HANDLE;
  VkShaderModule fragment = VK_NULL_HANDLE;
  WelkinResult result = createModule(device, kDomeVert, sizeof(kDomeVert), vertex, message);
  if (result == WELKIN_OK) result = createModule(device, kDomeFrag, sizeof(kDomeFrag), fragment, message);
  if (result == WELKIN_OK) result = createPipelines(device, info, vertex, fragment, dome, message);
  device.fn.DestroyShaderModule(device.handle, vertex, device.allocator);
  device.fn.DestroyShaderModule(device.handle, fragment, device.allocator);
  if (result != WELKIN_OK) return result;
  device.name(VK_OBJECT_TYPE_PIPELINE, dome.pipelines[WELKIN_VULKAN_ANALYTIC], "welkin dome, analytic");
  device.name(VK_OBJECT_TYPE_PIPELINE, dome.pipelines[WELKIN_VULKAN_CUBEMAP], "welkin dome, cubemap");
  return WELKIN_OK;
}

void destroy(const Device& device, DomePipeline& dome) {
  for (VkPipeline pipeline : dome.pipelines) device.fn.DestroyPipeline(device.handle, pipeline, device.allocator);
  device.fn.DestroyPipelineLayout(device.handle, dome.layout, device.allocator);
  dome = {};
}

void recordDome(const Device& device, const DomePipeline& dome, VkCommandBuffer commands, VkDescriptorSet set,
                WelkinVulkanSource source, float opacity, const passes::DomePush& push) {
  const bool blend = opacity > 0.0F && opacity < 1.0F;
  const float constants[4] = {0.0F, 0.0F, 0.0F, opacity};
  device.fn.CmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, dome.pipelines[source + (blend ? 2 : 0)]);
  device.fn.CmdSetBlendConstants(commands, constants);
  device.fn.CmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, dome.layout, 0, 1, &set, 0, nullptr);
  device.fn.CmdPushConstants(commands, dome.layout, VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                             sizeof(push), &push);
  device.fn.CmdDraw(commands, 3, 1, 0, 0);
}

}  // namespace welkin::vulkan
