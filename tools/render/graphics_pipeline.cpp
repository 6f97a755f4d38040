// SPDX-License-Identifier: Apache-2.0
// Creates graphics pipelines.
#include "render/graphics_pipeline.h"

namespace welkin::render {
namespace {

/// A shader module that lives while its pipeline is being made.
class Module {
 public:
  Module(VkDevice device, std::span<const uint32_t> words) : device_(device) {
    VkShaderModuleCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    info.codeSize = words.size_bytes();
    info.pCode = words.data();
    if (!words.empty()) require(vkCreateShaderModule(device, &info, nullptr, &handle_), "vkCreateShaderModule");
  }
  ~Module() { vkDestroyShaderModule(device_, handle_, nullptr); }
  Module(const Module&) = delete;
  Module& operator=(const Module&) = delete;

  VkPipelineShaderStageCreateInfo stage(VkShaderStageFlagBits stage) const {
    VkPipelineShaderStageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage = stage;
    info.module = handle_;
    info.pName = "main";
    return info;
  }

 private:
  VkDevice device_;
  VkShaderModule handle_ = VK_NULL_HANDLE;
};

}  // namespace

VkPipeline createGraphicsPipeline(VkDevice device, const PipelineDescription& d) {
  const Module vertex(device, d.vertex);
  const Module fragment(device, d.fragment);
  const VkPipelineShaderStageCreateInfo stages[2] = {vertex.stage(VK_SHADER_STAGE_VERTEX_BIT),
                                                     fragment.stage(VK_SHADER_STAGE_FRAGMENT_BIT)};
  const VkVertexInputBindingDescription binding{
      0, d.vertex_bytes, d.per_instance ? VK_VERTEX_INPUT_RATE_INSTANCE : VK_VERTEX_INPUT_RATE_VERTEX};
  VkPipelineVertexInputStateCreateInfo input{};
  input.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
  input.vertexBindingDescriptionCount = d.attributes.empty() ? 0 : 1;
  input.pVertexBindingDescriptions = &binding;
  input.vertexAttributeDescriptionCount = static_cast<uint32_t>(d.attributes.size());
  input.pVertexAttributeDescriptions = d.attributes.data();
  VkPipelineInputAssemblyStateCreateInfo assembly{};
  assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  VkPipelineViewportStateCreateInfo viewport{};
  viewport.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
  viewport.viewportCount = 1;
  viewport.scissorCount = 1;
  VkPipelineRasterizationStateCreateInfo raster{};
  raster.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
  raster.lineWidth = 1.0F;
  raster.depthBiasEnable = d.depth_bias_slope != 0.0F ? VK_TRUE : VK_FALSE;
  raster.depthBiasSlopeFactor = d.depth_bias_slope;
  VkPipelineMultisampleStateCreateInfo samples{};
  samples.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
  samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
  VkPipelineDepthStencilStateCreateInfo depth{};
  depth.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
  depth.depthTestEnable = d.depth != VK_FORMAT_UNDEFINED ? VK_TRUE : VK_FALSE;
  depth.depthWriteEnable = d.depth_write ? VK_TRUE : VK_FALSE;
  depth.depthCompareOp = d.depth_compare;
  VkPipelineColorBlendAttachmentState blended{};
  blended.colorWriteMask =
      VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
  blended.blendEnable = d.dual_source ? VK_TRUE : VK_FALSE;
  blended.srcColorBlendFactor = VK_BLEND_FACTOR_ONE;
  blended.dstColorBlendFactor = VK_BLEND_FACTOR_SRC1_COLOR;
  blended.srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
  blended.dstAlphaBlendFactor = VK_BLEND_FACTOR_SRC1_ALPHA;
  const std::vector<VkPipelineColorBlendAttachmentState> attachments(d.colours.size(), blended);
  VkPipelineColorBlendStateCreateInfo blend{};
  blend.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
  blend.attachmentCount = static_cast<uint32_t>(attachments.size());
  blend.pAttachments = attachments.data();
  const VkDynamicState states[4] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR, VK_DYNAMIC_STATE_CULL_MODE,
                                    VK_DYNAMIC_STATE_FRONT_FACE};
  VkPipelineDynamicStateCreateInfo dynamic{};
  dynamic.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
  dynamic.dynamicStateCount = d.dynamic_culling ? 4 : 2;
  dynamic.pDynamicStates = states;
  VkPipelineRenderingCreateInfo rendering{};
  rendering.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO;
  rendering.colorAttachmentCount = static_cast<uint32_t>(d.colours.size());
  rendering.pColorAttachmentFormats = d.colours.data();
  rendering.depthAttachmentFormat = d.depth;
  VkGraphicsPipelineCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
  info.pNext = &rendering;
  info.stageCount = d.fragment.empty() ? 1 : 2;
  info.pStages = stages;
  info.pVertexInputState = &input;
  info.pInputAssemblyState = &assembly;
  info.pViewportState = &viewport;
  info.pRasterizationState = &raster;
  info.pMultisampleState = &samples;
  info.pDepthStencilState = &depth;
  info.pColorBlendState = &blend;
  info.pDynamicState = &dynamic;
  info.layout = d.layout;
  VkPipeline pipeline = VK_NULL_HANDLE;
  require(vkCreateGraphicsPipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline), "vkCreateGraphicsPipelines");
  return pipeline;
}

}  // namespace welkin::render
