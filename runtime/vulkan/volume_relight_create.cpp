// SPDX-License-Identifier: Apache-2.0
// Buffers, sets and pipelines of the passes that relight and fill a volume.
#include <algorithm>
#include <cstdint>
#include <new>

#include "passes/volume_relight.h"
#include "spirv/kVolumeFill.h"
#include "spirv/kVolumeRelight.h"
#include "vulkan/compute_pipeline.h"
#include "vulkan/volume_relight.h"

namespace welkin::vulkan {
namespace {

constexpr uint32_t kBindingCount = 5;
constexpr VkDescriptorPoolSize kRelightBound[kBindingCount] = {{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1},
                                                               {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1},
                                                               {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1},
                                                               {VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, 1},
                                                               {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, 3}};

WelkinResult createBuffers(const Device& device, uint32_t frames, VolumeRelight& o, WelkinMessage* message) {
  const VkDeviceSize slots = VkDeviceSize{o.slots} * 4 * WELKIN_SLOT_WORDS;
  const VkDeviceSize alignment = std::max<VkDeviceSize>(device.properties.limits.minStorageBufferOffsetAlignment, 16);
  const auto round = [&](VkDeviceSize bytes) { return (bytes + alignment - 1) / alignment * alignment; };
  o.light_bytes = round(sizeof(passes::VolumeLight) + o.slots * sizeof(passes::SlotLight));
  o.frame_bytes = round(o.light_bytes + slots);
  if (const auto r = createMapped(device, o.frame_bytes * frames,
                                  VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                                  "welkin volume relight staging", o.staging, message))
    return r;
  if (const auto r = createLocal(device, slots, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                 "welkin volume probes", o.probes, message))
    return r;
  return createLocal(device, VkDeviceSize{o.slots} * WELKIN_SLOT_PROBES * sizeof(float) * probes::kColours,
                     VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, "welkin volume relit", o.relit, message);
}

void writeSets(const Device& device, const RelightImages& images, uint32_t frames, const VolumeRelight& o) {
  const VkDescriptorImageInfo words{VK_NULL_HANDLE, images.words, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
  VkDescriptorImageInfo texels[3];
  for (int c = 0; c < 3; ++c) texels[c] = {VK_NULL_HANDLE, images.texel_views[c], VK_IMAGE_LAYOUT_GENERAL};
  for (uint32_t frame = 0; frame < frames; ++frame) {
    const VkDescriptorBufferInfo buffers[3] = {{o.staging.buffer, frame * o.frame_bytes, o.light_bytes},
                                               {o.probes.buffer, 0, VK_WHOLE_SIZE},
                                               {o.relit.buffer, 0, VK_WHOLE_SIZE}};
    VkWriteDescriptorSet writes[kBindingCount] = {};
    for (uint32_t i = 0; i < kBindingCount; ++i) {
      writes[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
      writes[i].dstSet = o.sets.sets[frame];
      writes[i].dstBinding = i;
      writes[i].descriptorCount = kRelightBound[i].descriptorCount;
      writes[i].descriptorType = kRelightBound[i].type;
      if (i < 3) writes[i].pBufferInfo = &buffers[i];
    }
    writes[3].pImageInfo = &words;
    writes[4].pImageInfo = texels;
    device.fn.UpdateDescriptorSets(device.handle, kBindingCount, writes, 0, nullptr);
  }
}

}  // namespace

WelkinResult createRelight(const Device& device, const WelkinVolume& volume, const RelightImages& images,
                           uint32_t frames, VkPipelineCache cache, VolumeRelight& o, WelkinMessage* message) {
  o.slots = volume.slots[0] * volume.slots[1];
  o.slot = new (std::nothrow) RelightSlot[2 * o.slots];
  if (o.slot == nullptr) return fail(message, WELKIN_ERROR_MEMORY, "out of host memory");
  if (const auto r = createBuffers(device, frames, o, message)) return r;
  if (const auto r = createFrameSets(device, kRelightBound, VK_SHADER_STAGE_COMPUTE_BIT, frames, o.sets, message))
    return r;
  writeSets(device, images, frames, o);
  VkPipelineLayoutCreateInfo layout{};
  layout.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  layout.setLayoutCount = 1;
  layout.pSetLayouts = &o.sets.layout;
  if (const auto r = check(device.fn.CreatePipelineLayout(device.handle, &layout, device.allocator, &o.pipeline_layout),
                           "vkCreatePipelineLayout", message))
    return r;
  if (const auto r = createComputePipeline(device, kVolumeRelight, cache, "welkin volume relight", o.pipeline_layout,
                                           o.pipelines[0], message))
    return r;
  return createComputePipeline(device, kVolumeFill, cache, "welkin volume fill", o.pipeline_layout, o.pipelines[1],
                               message);
}

void destroy(const Device& device, VolumeRelight& o) {
  for (VkPipeline pipeline : o.pipelines) device.fn.DestroyPipeline(device.handle, pipeline, device.allocator);
  device.fn.DestroyPipelineLayout(device.handle, o.pipeline_layout, device.allocator);
  destroy(device, o.sets);
  destroy(device, o.staging);
  destroy(device, o.probes);
  destroy(device, o.relit);
  delete[] o.slot;
  o = {};
}

}  // namespace welkin::vulkan
