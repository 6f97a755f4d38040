// SPDX-License-Identifier: Apache-2.0
// Creates the pipelines of the level picture.
#include "render/level_pipelines.h"

#include <cstdint>
#include <vector>

#include "render/graphics_pipeline.h"
#include "render/level_mesh.h"
#include "render/offscreen.h"
#include "render/probe_sphere.h"
#include "render/shaders/level_glass_push.h"
#include "spirv/kFullscreenVert.h"
#include "spirv/kLevelGlassFrag.h"
#include "spirv/kLevelGlassOfModesFrag.h"
#include "spirv/kLevelGlassOfProbesAndModesFrag.h"
#include "spirv/kLevelGlassOfProbesFrag.h"
#include "spirv/kLevelGlossyFrag.h"
#include "spirv/kLevelGlossyOfModesFrag.h"
#include "spirv/kLevelGlossyOfProbesAndModesFrag.h"
#include "spirv/kLevelGlossyOfProbesFrag.h"
#include "spirv/kLevelLightFrag.h"
#include "spirv/kLevelLightOfModesFrag.h"
#include "spirv/kLevelLightOfProbesAndModesFrag.h"
#include "spirv/kLevelLightOfProbesFrag.h"
#include "spirv/kLevelPlaceFrag.h"
#include "spirv/kLevelProbesFrag.h"
#include "spirv/kLevelProbesVert.h"
#include "spirv/kLevelShadowVert.h"
#include "spirv/kLevelSurfaceFrag.h"
#include "spirv/kLevelSurfaceVert.h"
#include "spirv/kLevelWaterFrag.h"
#include "spirv/kLevelWaterOfModesFrag.h"
#include "spirv/kLevelWaterOfProbesAndModesFrag.h"
#include "spirv/kLevelWaterOfProbesFrag.h"
#include "spirv/kLevelWaterVert.h"

namespace welkin::render {

LevelPipelines::LevelPipelines(const VulkanDevice& device, VkDescriptorSetLayout sky, VkDescriptorSetLayout volume,
                               VkDescriptorSetLayout reflection, bool light_of_modes)
    : device_(device.device()) {
  try {
    createLayouts(sky, volume, reflection);
    createSamplers();
    createPipelines(light_of_modes, volume != VK_NULL_HANDLE);
  } catch (...) {
    destroy();
    throw;
  }
}

void LevelPipelines::destroy() {
  for (VkPipeline pipeline : {shadow, surface, light, glossy, place, probes, glass, water})
    vkDestroyPipeline(device_, pipeline, nullptr);
  vkDestroyPipelineLayout(device_, layout_, nullptr);
  vkDestroyDescriptorSetLayout(device_, set_, nullptr);
  vkDestroySampler(device_, shadow_sampler_, nullptr);
  vkDestroySampler(device_, sampler_, nullptr);
}

void LevelPipelines::createLayouts(VkDescriptorSetLayout sky, VkDescriptorSetLayout volume,
                                   VkDescriptorSetLayout reflection) {
  VkDescriptorSetLayoutBinding bindings[WELKIN_LEVEL_BINDINGS] = {};
  for (uint32_t i = 0; i < WELKIN_LEVEL_BINDINGS; ++i) {
    bindings[i].binding = i;
    const bool storage = i == WELKIN_LEVEL_INSTANCES || i == WELKIN_LEVEL_LAMPS || i == WELKIN_LEVEL_BOXES ||
                         i == WELKIN_LEVEL_TRIANGLES || i == WELKIN_LEVEL_CONTACT;
    bindings[i].descriptorType = i == WELKIN_LEVEL_CONSTANTS ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER
                                 : storage                   ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER
                                                             : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    bindings[i].descriptorCount = 1;
    bindings[i].stageFlags = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;
  }
  VkDescriptorSetLayoutCreateInfo set{};
  set.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
  set.bindingCount = WELKIN_LEVEL_BINDINGS;
  set.pBindings = bindings;
  require(vkCreateDescriptorSetLayout(device_, &set, nullptr, &set_), "vkCreateDescriptorSetLayout");
  std::vector<VkDescriptorSetLayout> sets = {sky, set_, volume, reflection};
  if (volume == VK_NULL_HANDLE) sets.erase(sets.begin() + 2);
  VkPipelineLayoutCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  info.setLayoutCount = static_cast<uint32_t>(sets.size());
  info.pSetLayouts = sets.data();
  const VkPushConstantRange of_glass{VK_SHADER_STAGE_FRAGMENT_BIT, 0, sizeof(shaders::GlassPush)};
  info.pushConstantRangeCount = 1;
  info.pPushConstantRanges = &of_glass;
  require(vkCreatePipelineLayout(device_, &info, nullptr, &layout_), "vkCreatePipelineLayout");
}

void LevelPipelines::createSamplers() {
  VkSamplerCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
  info.addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;  // nearest
  info.addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  require(vkCreateSampler(device_, &info, nullptr, &sampler_), "vkCreateSampler");
  info.magFilter = VK_FILTER_LINEAR;
  info.minFilter = VK_FILTER_LINEAR;
  info.addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER;  // outside the level nothing casts a shadow
  info.addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER;
  info.borderColor = VK_BORDER_COLOR_FLOAT_OPAQUE_WHITE;
  info.compareEnable = VK_TRUE;
  info.compareOp = VK_COMPARE_OP_LESS_OR_EQUAL;
  require(vkCreateSampler(device_, &info, nullptr, &shadow_sampler_), "vkCreateSampler");
}

void LevelPipelines::createPipelines(bool light_of_modes, bool of_probes) {
  using Words = std::span<const uint32_t>;
  const auto variant = [&](Words sh, Words modes, Words probes_and_sh, Words probes_and_modes) {
    return of_probes ? (light_of_modes ? probes_and_modes : probes_and_sh) : (light_of_modes ? modes : sh);
  };
  const auto attributes = LevelMesh::attributes();
  shadow = createGraphicsPipeline(device_, {.layout = layout_,
                                            .vertex = kLevelShadowVert,
                                            .attributes = attributes.first(1),
                                            .vertex_bytes = sizeof(level::Vertex),
                                            .depth = kDepthFormat,
                                            .depth_compare = VK_COMPARE_OP_LESS,
                                            .depth_write = true,
                                            .depth_bias_slope = 1.0F});
  surface = createGraphicsPipeline(device_, {.layout = layout_,
                                             .vertex = kLevelSurfaceVert,
                                             .fragment = kLevelSurfaceFrag,
                                             .attributes = attributes,
                                             .vertex_bytes = sizeof(level::Vertex),
                                             .colours = {kSurfaceFormat, kSurfaceFormat, Offscreen::kFormat},
                                             .depth = kDepthFormat,
                                             .depth_compare = VK_COMPARE_OP_GREATER,
                                             .depth_write = true,
                                             .dynamic_culling = true});
  // The full-screen triangle has depth 0, less than any surface.
  const auto lit = [&](Words fragment) {
    return createGraphicsPipeline(device_, {.layout = layout_,
                                            .vertex = kFullscreenVert,
                                            .fragment = fragment,
                                            .colours = {Offscreen::kFormat},
                                            .depth = kDepthFormat,
                                            .depth_compare = VK_COMPARE_OP_LESS});
  };
  light =
      lit(variant(kLevelLightFrag, kLevelLightOfModesFrag, kLevelLightOfProbesFrag, kLevelLightOfProbesAndModesFrag));
  glossy = lit(
      variant(kLevelGlossyFrag, kLevelGlossyOfModesFrag, kLevelGlossyOfProbesFrag, kLevelGlossyOfProbesAndModesFrag));
  place = createGraphicsPipeline(device_, {.layout = layout_,
                                           .vertex = kFullscreenVert,
                                           .fragment = kLevelPlaceFrag,
                                           .colours = {Offscreen::kFormat},
                                           .depth = kDepthFormat,
                                           .depth_compare = VK_COMPARE_OP_LESS});
  probes = createGraphicsPipeline(device_, {.layout = layout_,
                                            .vertex = kLevelProbesVert,
                                            .fragment = kLevelProbesFrag,
                                            .attributes = ProbeSphere::kAttributes,
                                            .vertex_bytes = sizeof(ProbeSphere),
                                            .per_instance = true,
                                            .colours = {Offscreen::kFormat},
                                            .depth = kDepthFormat,
                                            .depth_compare = VK_COMPARE_OP_GREATER,
                                            .depth_write = true});
  glass =
      createGraphicsPipeline(device_, {.layout = layout_,
                                       .vertex = kLevelSurfaceVert,
                                       .fragment = variant(kLevelGlassFrag, kLevelGlassOfModesFrag,
                                                           kLevelGlassOfProbesFrag, kLevelGlassOfProbesAndModesFrag),
                                       .attributes = attributes,
                                       .vertex_bytes = sizeof(level::Vertex),
                                       .colours = {Offscreen::kFormat},
                                       .depth = kDepthFormat,
                                       .depth_compare = VK_COMPARE_OP_GREATER,
                                       .dual_source = true});
  water =
      createGraphicsPipeline(device_, {.layout = layout_,
                                       .vertex = kLevelWaterVert,
                                       .fragment = variant(kLevelWaterFrag, kLevelWaterOfModesFrag,
                                                           kLevelWaterOfProbesFrag, kLevelWaterOfProbesAndModesFrag),
                                       .colours = {Offscreen::kFormat},
                                       .depth = kDepthFormat,
                                       .depth_compare = VK_COMPARE_OP_GREATER_OR_EQUAL});
}

}  // namespace welkin::render
