// SPDX-License-Identifier: Apache-2.0
// Image, sets and pipeline of the filtered sky.
#include "passes/reflection_filter.h"
#include "spirv/kReflectionFilter.h"
#include "vulkan/compute_pipeline.h"
#include "vulkan/reflection_object.h"

namespace welkin::vulkan {
namespace {

constexpr const char* kName = "welkin reflection";
constexpr VkFormat kReflectionFormat = VK_FORMAT_R16G16B16A16_SFLOAT;

WelkinResult createImage(WelkinVulkanReflection& o, WelkinMessage* message) {
  const Device& device = o.device;
  VkImageCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
  info.flags = VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT;
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = kReflectionFormat;
  info.extent = {o.size, o.size, 1};
  info.mipLevels = o.mips;
  info.arrayLayers = 6;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.tiling = VK_IMAGE_TILING_OPTIMAL;
  info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT;
  if (const auto r = check(device.fn.CreateImage(device.handle, &info, device.allocator, &o.image), kName, message))
    return r;
  device.name(VK_OBJECT_TYPE_IMAGE, o.image, kName);
  VkMemoryRequirements needs;
  device.fn.GetImageMemoryRequirements(device.handle, o.image, &needs);
  if (const auto r = allocateImages(device, needs, kName, o.memory, message)) return r;
  o.bytes = needs.size;
  return check(device.fn.BindImageMemory(device.handle, o.image, o.memory.memory, o.memory.offset), kName, message);
}

WelkinResult createView(const WelkinVulkanReflection& o, VkImageViewType type, uint32_t mip, uint32_t mips,
                        VkImageView& view, WelkinMessage* message) {
  VkImageViewCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
  info.image = o.image;
  info.viewType = type;
  info.format = kReflectionFormat;
  info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, mip, mips, 0, 6};
  return check(o.device.fn.CreateImageView(o.device.handle, &info, o.device.allocator, &view), kName, message);
}

WelkinResult createViews(WelkinVulkanReflection& o, WelkinMessage* message) {
  if (const auto r = createView(o, VK_IMAGE_VIEW_TYPE_CUBE, 0, o.mips, o.cube, message)) return r;
  for (uint32_t mip = 0; mip < o.mips; ++mip)
    if (const auto r = createView(o, VK_IMAGE_VIEW_TYPE_2D_ARRAY, mip, 1, o.mip_views[mip], message)) return r;
  return WELKIN_OK;
}

WelkinResult createSets(WelkinVulkanReflection& o, WelkinMessage* message) {
  const Device& device = o.device;
  VkSamplerCreateInfo sampler{};
  sampler.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
  sampler.magFilter = sampler.minFilter = VK_FILTER_LINEAR;
  sampler.mipmapMode = VK_SAMPLER_MIPMAP_MODE_LINEAR;
  sampler.maxLod = VK_LOD_CLAMP_NONE;
  sampler.addressModeU = sampler.addressModeV = sampler.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  if (const auto r = check(device.fn.CreateSampler(device.handle, &sampler, device.allocator, &o.sampler),
                           "vkCreateSampler", message))
    return r;
  constexpr VkDescriptorPoolSize kRead{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1};
  constexpr VkDescriptorPoolSize kWritten{VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, 1};
  if (const auto r = createFrameSets(device, {&kRead, 1}, VK_SHADER_STAGE_FRAGMENT_BIT | VK_SHADER_STAGE_COMPUTE_BIT, 1,
                                     o.read, message))
    return r;
  return createFrameSets(device, {&kWritten, 1}, VK_SHADER_STAGE_COMPUTE_BIT, o.mips, o.written, message);
}

void writeSet(const Device& device, VkDescriptorSet set, VkDescriptorType type, const VkDescriptorImageInfo& image) {
  VkWriteDescriptorSet write{};
  write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
  write.dstSet = set;
  write.descriptorCount = 1;
  write.descriptorType = type;
  write.pImageInfo = &image;
  device.fn.UpdateDescriptorSets(device.handle, 1, &write, 0, nullptr);
}

WelkinResult createPipeline(WelkinVulkanReflection& o, VkDescriptorSetLayout sky, VkPipelineCache cache,
                            WelkinMessage* message) {
  const VkDescriptorSetLayout sets[2] = {sky, o.written.layout};
  const VkPushConstantRange push{VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(passes::ReflectionPush)};
  VkPipelineLayoutCreateInfo layout{};
  layout.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  layout.setLayoutCount = 2;
  layout.pSetLayouts = sets;
  layout.pushConstantRangeCount = 1;
  layout.pPushConstantRanges = &push;
  const Device& device = o.device;
  if (const auto r = check(device.fn.CreatePipelineLayout(device.handle, &layout, device.allocator, &o.pipeline_layout),
                           "vkCreatePipelineLayout", message))
    return r;
  return createComputePipeline(device, kReflectionFilter, cache, kName, o.pipeline_layout, o.pipeline, message);
}

}  // namespace

WelkinResult createReflection(WelkinVulkanReflection& o, VkDescriptorSetLayout sky, VkPipelineCache cache,
                              WelkinMessage* message) {
  if (const auto r = createImage(o, message)) return r;
  if (const auto r = createViews(o, message)) return r;
  if (const auto r = createSets(o, message)) return r;
  writeSet(o.device, o.read.sets[0], VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
           {o.sampler, o.cube, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
  for (uint32_t mip = 0; mip < o.mips; ++mip)
    writeSet(o.device, o.written.sets[mip], VK_DESCRIPTOR_TYPE_STORAGE_IMAGE,
             {VK_NULL_HANDLE, o.mip_views[mip], VK_IMAGE_LAYOUT_GENERAL});
  return createPipeline(o, sky, cache, message);
}

void destroy(WelkinVulkanReflection& o) {
  const Device& device = o.device;
  device.fn.DestroyPipeline(device.handle, o.pipeline, device.allocator);
  device.fn.DestroyPipelineLayout(device.handle, o.pipeline_layout, device.allocator);
  destroy(device, o.read);
  destroy(device, o.written);
  device.fn.DestroySampler(device.handle, o.sampler, device.allocator);
  for (VkImageView view : o.mip_views) device.fn.DestroyImageView(device.handle, view, device.allocator);
  device.fn.DestroyImageView(device.handle, o.cube, device.allocator);
  device.fn.DestroyImage(device.handle, o.image, device.allocator);
  freeMemory(device, o.memory);
}

}  // namespace welkin::vulkan
