// SPDX-License-Identifier: Apache-2.0
// Creates a graphics pipeline for dynamic rendering from the settings in which pipelines differ.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/vulkan_device.h"

namespace welkin::render {

/// Viewport and scissor are dynamic. One sample, triangles. No vertex inputs unless they are given.
struct PipelineDescription {
  VkPipelineLayout layout = VK_NULL_HANDLE;
  std::span<const uint32_t> vertex{};
  std::span<const uint32_t> fragment{};                             ///< empty: depth alone
  std::span<const VkVertexInputAttributeDescription> attributes{};  ///< attributes of binding 0
  uint32_t vertex_bytes = 0;
  bool per_instance = false;  ///< attributes advance with the instance, not with the vertex
  std::vector<VkFormat> colours{};
  VkFormat depth = VK_FORMAT_UNDEFINED;
  VkCompareOp depth_compare = VK_COMPARE_OP_ALWAYS;
  bool depth_write = false;
  bool dual_source = false;  ///< the result is the first source plus the second times what is there; else no blending
  float depth_bias_slope = 0.0F;
  bool dynamic_culling = false;  ///< cull mode and front face are dynamic; else nothing is culled
};

/// Throws Error(file) when the device refuses.
VkPipeline createGraphicsPipeline(VkDevice device, const PipelineDescription& description);

}  // namespace welkin::render
