// SPDX-License-Identifier: Apache-2.0
// One descriptor set for every frame in flight, all of one layout.
#pragma once

#include <span>

#include "vulkan/device.h"

namespace welkin::vulkan {

struct FrameSets {
  VkDescriptorSetLayout layout = VK_NULL_HANDLE;
  VkDescriptorPool pool = VK_NULL_HANDLE;
  VkDescriptorSet sets[WELKIN_VULKAN_MAX_FRAMES_IN_FLIGHT] = {};
};

inline constexpr uint32_t kMostBindings = 8;

/// Creates layout, pool and `frames` sets. Binding i has the type and number of `bound[i]`; at most kMostBindings.
WelkinResult createFrameSets(const Device& device, std::span<const VkDescriptorPoolSize> bound,
                             VkShaderStageFlags stages, uint32_t frames, FrameSets& o, WelkinMessage* message);
void destroy(const Device& device, FrameSets& o);

}  // namespace welkin::vulkan
