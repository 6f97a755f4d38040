// SPDX-License-Identifier: Apache-2.0
// Samplers, layout, pool and sets.
#include "vulkan/descriptors.h"

#include "welkin/sky_bindings.h"

namespace welkin::vulkan {
namespace {

constexpr uint32_t kImageBindings = 6;

WelkinResult createSampler(const Device& device, VkFilter filter, VkSamplerAddressMode columns, VkSampler& sampler,
                           WelkinMessage* message) {
  VkSamplerCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
  info.magFilter = filter;
  info.minFilter = filter;
  info.mipmapMode = filter == VK_FILTER_LINEAR ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
  info.maxLod = VK_LOD_CLAMP_NONE;
  info.addressModeU = columns;
  info.addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  return check(device.fn.CreateSampler(device.handle, &info, device.allocator, &sampler), "vkCreateSampler", message);
}

WelkinResult createLayout(const Device& device, VkDescriptorSetLayout& layout, WelkinMessage* message) {
  VkDescriptorSetLayoutBinding bindings[1 + kImageBindings] = {};
  for (uint32_t i = 0; i <= kImageBindings; ++i) {
    bindings[i].binding = i;
    bindings[i].descriptorType =
        i == WELKIN_BINDING_CONSTANTS ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    bindings[i].descriptorCount = 1;
    bindings[i].stageFlags = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT | VK_SHADER_STAGE_COMPUTE_BIT;
  }
  VkDescriptorSetLayoutCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
  info.bindingCount = 1 + kImageBindings;
  info.pBindings = bindings;
  return check(device.fn.CreateDescriptorSetLayout(device.handle, &info, device.allocator, &layout),
               "vkCreateDescriptorSetLayout", message);
}

WelkinResult createSets(const Device& device, uint32_t frames, Descriptors& descriptors, WelkinMessage* message) {
  const VkDescriptorPoolSize sizes[2] = {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, frames},
                                         {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, frames * kImageBindings}};
  VkDescriptorPoolCreateInfo pool{};
  pool.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
  pool.maxSets = frames;
  pool.poolSizeCount = 2;
  pool.pPoolSizes = sizes;
  if (const auto r = check(device.fn.CreateDescriptorPool(device.handle, &pool, device.allocator, &descriptors.pool),
                           "vkCreateDescriptorPool", message))
    return r;
  VkDescriptorSetLayout layouts[WELKIN_VULKAN_MAX_FRAMES_IN_FLIGHT];
  for (auto& layout : layouts) layout = descriptors.layout;
  VkDescriptorSetAllocateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
  info.descriptorPool = descriptors.pool;
  info.descriptorSetCount = frames;
  info.pSetLayouts = layouts;
  return check(device.fn.AllocateDescriptorSets(device.handle, &info, descriptors.sets), "vkAllocateDescriptorSets",
               message);
}

VkWriteDescriptorSet imageWrite(VkDescriptorSet set, uint32_t binding, const VkDescriptorImageInfo& image) {
  VkWriteDescriptorSet write{};
  write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
  write.dstSet = set;
  write.dstBinding = binding;
  write.descriptorCount = 1;
  write.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
  write.pImageInfo = &image;
  return write;
}

}  // namespace

WelkinResult createDescriptors(const Device& device, uint32_t frames, Descriptors& descriptors,
                               WelkinMessage* message) {
  constexpr auto kEdge = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  constexpr auto kWrap = VK_SAMPLER_ADDRESS_MODE_REPEAT;
  if (const auto r = createSampler(device, VK_FILTER_NEAREST, kEdge, descriptors.fetch, message)) return r;
  if (const auto r = createSampler(device, VK_FILTER_LINEAR, kEdge, descriptors.filter, message)) return r;
  if (const auto r = createSampler(device, VK_FILTER_LINEAR, kWrap, descriptors.wrap, message)) return r;
  if (const auto r = createLayout(device, descriptors.layout, message)) return r;
  if (const auto r = createSets(device, frames, descriptors, message)) return r;
  device.name(VK_OBJECT_TYPE_DESCRIPTOR_SET_LAYOUT, descriptors.layout, "welkin sky");
  for (uint32_t i = 0; i < frames; ++i) device.name(VK_OBJECT_TYPE_DESCRIPTOR_SET, descriptors.sets[i], "welkin sky");
  return WELKIN_OK;
}

void destroy(const Device& device, Descriptors& descriptors) {
  device.fn.DestroyDescriptorPool(device.handle, descriptors.pool, device.allocator);
  device.fn.DestroyDescriptorSetLayout(device.handle, descriptors.layout, device.allocator);
  device.fn.DestroySampler(device.handle, descriptors.wrap, device.allocator);
  device.fn.DestroySampler(device.handle, descriptors.filter, device.allocator);
  device.fn.DestroySampler(device.handle, descriptors.fetch, device.allocator);
  descriptors = {};
}

void writeFixedBindings(const Device& device, const Descriptors& descriptors, uint32_t frame,
                        const VkDescriptorBufferInfo& constants, VkImageView gradient_sun, VkImageView gradient_anti,
                        VkImageView stars, VkImageView modes) {
  const VkDescriptorSet set = descriptors.sets[frame];
  const VkDescriptorImageInfo sun{descriptors.fetch, gradient_sun, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
  const VkDescriptorImageInfo anti{descriptors.fetch, gradient_anti, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
  const VkDescriptorImageInfo map{descriptors.wrap, stars, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
  const VkDescriptorImageInfo mode_map{descriptors.filter, modes, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
  VkWriteDescriptorSet writes[5] = {{},
                                    imageWrite(set, WELKIN_BINDING_GRADIENT_SUN, sun),
                                    imageWrite(set, WELKIN_BINDING_GRADIENT_ANTI, anti),
                                    imageWrite(set, WELKIN_BINDING_STARS, map),
                                    imageWrite(set, WELKIN_BINDING_MODES, mode_map)};
  writes[0].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
  writes[0].dstSet = set;
  writes[0].dstBinding = WELKIN_BINDING_CONSTANTS;
  writes[0].descriptorCount = 1;
  writes[0].descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
  writes[0].pBufferInfo = &constants;
  device.fn.UpdateDescriptorSets(device.handle, 5, writes, 0, nullptr);
}

void writeCubemaps(const Device& device, const Descriptors& descriptors, uint32_t frame, VkImageView first,
                   VkImageView second) {
  const VkDescriptorSet set = descriptors.sets[frame];
  const VkDescriptorImageInfo images[2] = {{descriptors.filter, first, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL},
                                           {descriptors.filter, second, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL}};
  const VkWriteDescriptorSet writes[2] = {imageWrite(set, WELKIN_BINDING_CUBEMAP_FIRST, images[0]),
                                          imageWrite(set, WELKIN_BINDING_CUBEMAP_SECOND, images[1])};
  device.fn.UpdateDescriptorSets(device.handle, 2, writes, 0, nullptr);
}

}  // namespace welkin::vulkan
