// SPDX-License-Identifier: Apache-2.0
#include "vulkan/volume_images.h"

#include <welkin/volume_constants.h>

#include <algorithm>

namespace welkin::vulkan {
namespace {

/// What sets an image of the volume apart from the others.
struct Kind {
  VkFormat format;
  VkImageType type;
  VkImageViewType view;
  VkExtent3D extent;
  VkImageUsageFlags written;
};

Kind kindOf(const WelkinVulkanVolume& o, uint32_t image) {
  if (image == o.farMap())
    return {VK_FORMAT_R16G16_SFLOAT,
            VK_IMAGE_TYPE_2D,
            VK_IMAGE_VIEW_TYPE_2D,
            {o.far_edge, o.far_edge, 1},
            VK_IMAGE_USAGE_TRANSFER_DST_BIT};
  const VkImageUsageFlags written = image < o.copied ? VK_IMAGE_USAGE_TRANSFER_DST_BIT : VK_IMAGE_USAGE_STORAGE_BIT;
  return {image < o.textures() ? VK_FORMAT_R32_UINT : o.format, VK_IMAGE_TYPE_3D, VK_IMAGE_VIEW_TYPE_3D, o.extent,
          written};
}

WelkinResult createImages(WelkinVulkanVolume& o, WelkinMessage* message) {
  const Device& device = o.device;
  const uint32_t limit = device.properties.limits.maxImageDimension3D;
  if (std::max({o.extent.width, o.extent.height, o.extent.depth}) > limit)
    return fail(message, WELKIN_ERROR_DEVICE, "a volume of %u x %u x %u texels: the device allows %u", o.extent.width,
                o.extent.height, o.extent.depth, limit);
  VkImageCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
  info.mipLevels = 1;
  info.arrayLayers = 1;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.tiling = VK_IMAGE_TILING_OPTIMAL;
  VkMemoryRequirements block{0, 1, ~0U};
  const uint32_t count = o.farMap() + 1;
  VkDeviceSize offset[5];
  for (uint32_t c = 0; c < count; ++c) {
    const Kind kind = kindOf(o, c);
    info.imageType = kind.type;
    info.extent = kind.extent;
    info.format = kind.format;
    info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | kind.written;
    if (const auto r = check(device.fn.CreateImage(device.handle, &info, device.allocator, &o.images[c]),
                             "welkin volume", message))
      return r;
    device.name(VK_OBJECT_TYPE_IMAGE, o.images[c], c == o.farMap() ? "welkin far map" : "welkin volume");
    VkMemoryRequirements needs;
    device.fn.GetImageMemoryRequirements(device.handle, o.images[c], &needs);
    block.memoryTypeBits &= needs.memoryTypeBits;
    block.alignment = std::max(block.alignment, needs.alignment);
    offset[c] = (block.size + needs.alignment - 1) / needs.alignment * needs.alignment;
    block.size = offset[c] + needs.size;
  }
  if (const auto r = allocateImages(device, block, "welkin volume", o.image_memory, message)) return r;
  o.image_bytes = block.size;
  for (uint32_t c = 0; c < count; ++c) {
    if (const auto r = check(device.fn.BindImageMemory(device.handle, o.images[c], o.image_memory.memory,
                                                       o.image_memory.offset + offset[c]),
                             "welkin volume", message))
      return r;
    const Kind kind = kindOf(o, c);
    VkImageViewCreateInfo view{};
    view.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    view.image = o.images[c];
    view.viewType = kind.view;
    view.format = kind.format;
    view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    if (const auto r = check(device.fn.CreateImageView(device.handle, &view, device.allocator, &o.views[c]),
                             "welkin volume", message))
      return r;
  }
  return WELKIN_OK;
}

constexpr uint32_t kBindings = 4;
constexpr VkDescriptorPoolSize kBound[kBindings] = {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1},
                                                    {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 3},
                                                    {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1},
                                                    {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1}};

WelkinResult createSets(WelkinVulkanVolume& o, WelkinMessage* message) {
  const Device& device = o.device;
  VkSamplerCreateInfo sampler{};
  sampler.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
  sampler.magFilter = sampler.minFilter = VK_FILTER_LINEAR;
  sampler.addressModeU = sampler.addressModeV = sampler.addressModeW = VK_SAMPLER_ADDRESS_MODE_REPEAT;
  if (const auto r = check(device.fn.CreateSampler(device.handle, &sampler, device.allocator, &o.sampler),
                           "vkCreateSampler", message))
    return r;
  return createFrameSets(device, kBound, VK_SHADER_STAGE_FRAGMENT_BIT | VK_SHADER_STAGE_COMPUTE_BIT, o.frame_count,
                         o.sets, message);
}

void writeSets(const WelkinVulkanVolume& o) {
  VkDescriptorImageInfo textures[3];
  for (uint32_t c = 0; c < 3; ++c)
    textures[c] = {o.sampler, o.views[o.textures() + c], VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
  const VkDescriptorImageInfo far_map{o.sampler, o.views[o.farMap()], VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
  for (uint32_t frame = 0; frame < o.frame_count; ++frame) {
    const VkDescriptorBufferInfo constants{o.staging.buffer, frame * o.frame_bytes, sizeof(WelkinVolumeConstants)};
    const VkDescriptorBufferInfo cuts{o.cuts.buffer, 0, o.cut_bytes};
    VkWriteDescriptorSet writes[kBindings] = {};
    for (uint32_t i = 0; i < kBindings; ++i) {
      writes[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
      writes[i].dstSet = o.sets.sets[frame];
      writes[i].dstBinding = i;
      writes[i].descriptorCount = kBound[i].descriptorCount;
      writes[i].descriptorType = kBound[i].type;
    }
    writes[0].pBufferInfo = &constants;
    writes[1].pImageInfo = textures;
    writes[2].pBufferInfo = &cuts;
    writes[3].pImageInfo = &far_map;
    o.device.fn.UpdateDescriptorSets(o.device.handle, kBindings, writes, 0, nullptr);
  }
}

}  // namespace

WelkinResult createVolumeImages(WelkinVulkanVolume& o, WelkinMessage* message) {
  if (const auto r = createImages(o, message)) return r;
  const auto round = [](VkDeviceSize bytes, VkDeviceSize to) { return (bytes + to - 1) / to * to; };
  // A multiple of 16 suits the copies of every texel, too.
  const VkDeviceSize alignment = std::max<VkDeviceSize>(o.device.properties.limits.minUniformBufferOffsetAlignment, 16);
  o.constants_bytes = round(sizeof(WelkinVolumeConstants), 16);
  const VkDeviceSize slice = VkDeviceSize{o.extent.width} * o.extent.height * o.texel_bytes;
  // An update's boxes may overlap, such as two slabs that meet at an edge: at most three of them, and two runs. Bricks
  // are in one of them.
  const VkDeviceSize most = slice * (4 * (o.slices + 1) + o.extent.depth);
  o.frame_bytes = round(o.texelStaging() + o.copied * most, alignment);
  if (const auto r = createMapped(o.device, o.frame_bytes * o.frame_count,
                                  VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                                  "welkin volume staging", o.staging, message))
    return r;
  if (const auto r =
          createLocal(o.device, o.cut_bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                      "welkin volume cuts", o.cuts, message))
    return r;
  if (const auto r = createSets(o, message)) return r;
  writeSets(o);
  return WELKIN_OK;
}

void destroy(WelkinVulkanVolume& o) {
  const Device& device = o.device;
  destroy(device, o.sets);
  device.fn.DestroySampler(device.handle, o.sampler, device.allocator);
  destroy(device, o.staging);
  destroy(device, o.cuts);
  for (uint32_t c = 0; c < 5; ++c) {
    device.fn.DestroyImageView(device.handle, o.views[c], device.allocator);
    device.fn.DestroyImage(device.handle, o.images[c], device.allocator);
  }
  freeMemory(device, o.image_memory);
}

}  // namespace welkin::vulkan
