// SPDX-License-Identifier: Apache-2.0
#include "vulkan/frame_sets.h"

#include <algorithm>

namespace welkin::vulkan {

WelkinResult createFrameSets(const Device& device, std::span<const VkDescriptorPoolSize> bound,
                             VkShaderStageFlags stages, uint32_t frames, FrameSets& o, WelkinMessage* message) {
  VkDescriptorSetLayoutBinding bindings[kMostBindings] = {};
  VkDescriptorPoolSize sizes[kMostBindings];
  const auto count = static_cast<uint32_t>(bound.size());
  for (uint32_t i = 0; i < count; ++i) {
    bindings[i].binding = i;
    bindings[i].descriptorType = bound[i].type;
    bindings[i].descriptorCount = bound[i].descriptorCount;
    bindings[i].stageFlags = stages;
    sizes[i] = {bound[i].type, bound[i].descriptorCount * frames};
  }
  VkDescriptorSetLayoutCreateInfo layout{};
  layout.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
  layout.bindingCount = count;
  layout.pBindings = bindings;
  if (const auto r = check(device.fn.CreateDescriptorSetLayout(device.handle, &layout, device.allocator, &o.layout),
                           "vkCreateDescriptorSetLayout", message))
    return r;
  VkDescriptorPoolCreateInfo pool{};
  pool.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
  pool.maxSets = frames;
  pool.poolSizeCount = count;
  pool.pPoolSizes = sizes;
  if (const auto r = check(device.fn.CreateDescriptorPool(device.handle, &pool, device.allocator, &o.pool),
                           "vkCreateDescriptorPool", message))
    return r;
  VkDescriptorSetLayout layouts[WELKIN_VULKAN_MAX_FRAMES_IN_FLIGHT];
  std::fill_n(layouts, frames, o.layout);
  VkDescriptorSetAllocateInfo sets{};
  sets.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
  sets.descriptorPool = o.pool;
  sets.descriptorSetCount = frames;
  sets.pSetLayouts = layouts;
  return check(device.fn.AllocateDescriptorSets(device.handle, &sets, o.sets), "vkAllocateDescriptorSets", message);
}

void destroy(const Device& device, FrameSets& o) {
  device.fn.DestroyDescriptorPool(device.handle, o.pool, device.allocator);
  device.fn.DestroyDescriptorSetLayout(device.handle, o.layout, device.allocator);
  o = {};
}

}  // namespace welkin::vulkan
