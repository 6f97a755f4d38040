// SPDX-License-Identifier: Apache-2.0
// Runs a compute shader that reads one storage buffer and writes another.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/vulkan_device.h"

namespace welkin::tests {

/// Set 0, bindings 0 (input) and 1 (output), are the buffers. Set 1 is `sky`, if there is one. There is one invocation
/// for each `per_invocation` output floats, in groups of 64.
std::vector<float> runCompute(render::VulkanDevice& device, std::span<const uint32_t> spirv,
                              std::span<const float> input, std::size_t outputs, std::size_t per_invocation,
                              VkDescriptorSetLayout sky_layout, VkDescriptorSet sky);

/// Least time of `runs` runs after a first, seconds, and the waiting for them.
double computeSeconds(render::VulkanDevice& device, std::span<const uint32_t> spirv, std::span<const float> input,
                      std::size_t outputs, int runs, std::size_t per_invocation = 1,
                      VkDescriptorSetLayout sky_layout = VK_NULL_HANDLE, VkDescriptorSet sky = VK_NULL_HANDLE);

}  // namespace welkin::tests
