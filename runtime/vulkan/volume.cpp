// SPDX-License-Identifier: Apache-2.0
// The C interface of welkin_vulkan_volume.h.
#include "probes/volume.h"

#include <welkin/volume_constants.h>

#include <cstddef>
#include <cstring>
#include <new>

#include "vulkan/barriers.h"
#include "vulkan/far_image.h"
#include "vulkan/volume_images.h"

namespace welkin::vulkan {
namespace {

using core::nonNull;
using core::refuse;

/// Copies a box of one channel to `to`, row by row. Returns the bytes after it.
unsigned char* stage(const WelkinVulkanVolume& o, const std::byte* texels, const WelkinVolumeBox& box,
                     unsigned char* to) {
  const std::size_t row = box.size[0] * o.texel_bytes;
  for (uint32_t z = box.first[2]; z < box.first[2] + box.size[2]; ++z)
    for (uint32_t y = box.first[1]; y < box.first[1] + box.size[1]; ++y, to += row) {
      const std::size_t texel = box.first[0] + o.extent.width * (y + std::size_t{o.extent.height} * z);
      std::memcpy(to, texels + texel * o.texel_bytes, row);
    }
  return to;
}

/// Copies the words of the cuts that changed to the frame's staging memory, after its constants, and records their way.
void recordCuts(const WelkinVulkanVolume& o, VkCommandBuffer commands, uint32_t frame, const WelkinVolume& volume,
                const WelkinVolumeUpdate& update) {
  const VkDeviceSize offset = frame * o.frame_bytes + o.cutStaging();
  const auto* words = reinterpret_cast<const std::byte*>(volume.cuts.words().data());
  std::memcpy(o.staging.mapped + offset, words + update.cut_first, update.cut_bytes);
  recordBarrier(o.device, commands, o.cuts.buffer, o.recorded ? kShaders : VK_PIPELINE_STAGE_2_NONE, VK_ACCESS_2_NONE,
                VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT);
  const VkBufferCopy region{offset, update.cut_first, update.cut_bytes};
  o.device.fn.CmdCopyBuffer(commands, o.staging.buffer, o.cuts.buffer, 1, &region);
  recordBarrier(o.device, commands, o.cuts.buffer, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                kShaders, VK_ACCESS_2_SHADER_STORAGE_READ_BIT);
}

/// Copies the boxes to the frame's staging memory and records their way to the images.
void recordBoxes(WelkinVulkanVolume& o, VkCommandBuffer commands, uint32_t frame, const WelkinVolume& volume,
                 const WelkinVolumeUpdate& update) {
  const uint32_t images = o.copied;
  VkImageMemoryBarrier2 before[3], between[3], after[3];
  for (uint32_t c = 0; c < images; ++c) {
    before[c] = imageBarrier(o.images[c], o.recorded ? kShaders : VK_PIPELINE_STAGE_2_NONE, VK_ACCESS_2_NONE,
                             o.recorded ? VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL : VK_IMAGE_LAYOUT_UNDEFINED,
                             VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                             VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    between[c] = imageBarrier(o.images[c], VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                              VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_PIPELINE_STAGE_2_COPY_BIT,
                              VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    after[c] = imageBarrier(o.images[c], VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                            VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, kShaders, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                            VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  }
  recordBarriers(o.device, commands, before, images);
  unsigned char* to = o.staging.mapped + frame * o.frame_bytes + o.texelStaging();
  // Boxes that overlap hold the same texels, but two copies to one texel must not race: each waits for the one before.
  for (uint32_t b = 0; b < update.box_count; ++b) {
    const WelkinVolumeBox& box = update.box[b];
    if (b > 0) recordBarriers(o.device, commands, between, images);
    for (uint32_t c = 0; c < images; ++c) {
      VkBufferImageCopy region{};
      region.bufferOffset = static_cast<VkDeviceSize>(to - o.staging.mapped);
      region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
      region.imageOffset = {static_cast<int32_t>(box.first[0]), static_cast<int32_t>(box.first[1]),
                            static_cast<int32_t>(box.first[2])};
      region.imageExtent = {box.size[0], box.size[1], box.size[2]};
      to = stage(o, volume.texels[c].get(), box, to);
      o.device.fn.CmdCopyBufferToImage(commands, o.staging.buffer, o.images[c], VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1,
                                       &region);
    }
  }
  recordBarriers(o.device, commands, after, images);
}

}  // namespace
}  // namespace welkin::vulkan

namespace core = welkin::core;
using namespace welkin::vulkan;

WelkinResult welkin_vulkan_volume_create(const WelkinVulkanCreateInfo* info, const WelkinVolume* volume,
                                         WelkinVulkanVolume** out, WelkinMessage* message) {
  if (out == nullptr) return fail(message, WELKIN_ERROR_ARGUMENT, "out is null");
  *out = nullptr;
  if (nonNull(__func__, {{"volume", volume}}) != WELKIN_OK || core::sized(__func__, "info", info) != WELKIN_OK)
    return fail(message, WELKIN_ERROR_ARGUMENT, "%s", welkin_argument_error());
  const WelkinVulkanCreateInfo given = core::take(*info);
  if (given.frames_in_flight < 1 || given.frames_in_flight > WELKIN_VULKAN_MAX_FRAMES_IN_FLIGHT)
    return fail(message, WELKIN_ERROR_ARGUMENT, "frames_in_flight is %u, must be 1 to %d", given.frames_in_flight,
                WELKIN_VULKAN_MAX_FRAMES_IN_FLIGHT);
  auto* object = new (std::nothrow) WelkinVulkanVolume;
  if (object == nullptr) return fail(message, WELKIN_ERROR_MEMORY, "out of host memory");
  if (const auto result = openDevice(given, object->device, message)) {
    delete object;  // some functions may be missing, and nothing has been created
    return result;
  }
  object->frame_count = given.frames_in_flight;
  object->extent = {volume->count[0], volume->count[1], volume->depth};
  object->slices = volume->count[2];
  object->texel_bytes = volume->texel_bytes;
  object->copied = static_cast<uint32_t>(volume->channels);
  object->cut_bytes = volume->cuts.words().size_bytes();
  object->far_edge = volume->far_map.edge();
  object->format = volume->format == WELKIN_VOLUME_RGBA8 ? VK_FORMAT_R8G8B8A8_UNORM : VK_FORMAT_R16G16B16A16_SFLOAT;
  WelkinResult result = createVolumeImages(*object, message);
  if (result == WELKIN_OK && object->relights())
    result = createRelight(object->device, *volume, object->relightImages(), object->frame_count, given.pipeline_cache,
                           object->relight, message);
  if (result != WELKIN_OK) {
    welkin_vulkan_volume_destroy(object);
    return result;
  }
  *out = object;
  return WELKIN_OK;
}

void welkin_vulkan_volume_destroy(WelkinVulkanVolume* object) {
  if (object == nullptr) return;
  destroy(object->device, object->relight);
  destroy(*object);
  delete object;
}

WelkinResult welkin_vulkan_volume_record(WelkinVulkanVolume* object, VkCommandBuffer commands, uint32_t frame,
                                         const WelkinVolume* volume, const WelkinVolumeUpdate* update) {
  if (const auto r = nonNull(__func__, {{"object", object}, {"commands", commands}, {"volume", volume}})) return r;
  if (const auto r = core::sized(__func__, "update", update)) return r;
  if (frame >= object->frame_count)
    return refuse(__func__, "frame is %u, must be below frames_in_flight, %u", frame, object->frame_count);
  const VkExtent3D& e = object->extent;
  if (e.width != volume->count[0] || e.height != volume->count[1] || e.depth != volume->depth ||
      object->texel_bytes != volume->texel_bytes || object->cut_bytes != volume->cuts.words().size_bytes() ||
      object->far_edge != volume->far_map.edge())
    return refuse(__func__, "the volume is not the one that this object was created for");
  const WelkinVolumeUpdate changed = core::take(*update);
  if (changed.box_count > WELKIN_VOLUME_MAX_BOXES)
    return refuse(__func__, "update->box_count is %u, must be at most %d", changed.box_count, WELKIN_VOLUME_MAX_BOXES);
  const uint32_t all = e.width * e.height * object->slices, edge[3] = {e.width, e.height, e.depth};
  for (uint32_t b = 0; b < changed.box_count; ++b)
    for (int a = 0; a < 3; ++a)
      if (changed.box[b].first[a] >= edge[a] || changed.box[b].size[a] > edge[a] - changed.box[b].first[a])
        return refuse(__func__, "update->box[%u] passes the volume", b);
  if (changed.cut_bytes > object->cut_bytes || changed.cut_first > object->cut_bytes - changed.cut_bytes)
    return refuse(__func__, "update->cut_bytes passes the cuts of the volume");
  if (changed.far_box_count > WELKIN_VOLUME_MAX_FAR_BOXES)
    return refuse(__func__, "update->far_box_count is %u, must be at most %d", changed.far_box_count,
                  WELKIN_VOLUME_MAX_FAR_BOXES);
  for (uint32_t b = 0; b < changed.far_box_count; ++b)
    if (!fitsFarMap(*object, changed.far_box[b])) return refuse(__func__, "update->far_box[%u] passes the far map", b);
  if (!object->recorded && (changed.box_count == 0 || changed.filled < all || changed.cut_bytes < object->cut_bytes))
    return refuse(__func__, "the first update that is recorded must fill the whole volume");
  if (object->relights() && volume->level == nullptr)
    return refuse(__func__, "the volume was not updated, and its format is WELKIN_VOLUME_DEVICE");
  WelkinVolumeConstants constants{};
  if (const auto r = welkin_volume_constants(volume, &constants, sizeof constants)) return r;
  std::memcpy(object->staging.mapped + frame * object->frame_bytes, &constants, sizeof constants);
  if (changed.cut_bytes != 0) recordCuts(*object, commands, frame, *volume, changed);
  if (changed.box_count > 0) {
    recordBoxes(*object, commands, frame, *volume, changed);
    object->recorded = true;
  }
  const bool knows_far_map = update->struct_size >= offsetof(WelkinVolumeUpdate, far_box) + sizeof changed.far_box;
  recordFarMap(*object, commands, frame, *volume, knows_far_map ? &changed : nullptr);
  if (object->relights())
    recordRelight(object->device, object->relight, object->relightImages(), *volume, commands, frame,
                  changed.box_count > 0);
  return WELKIN_OK;
}

VkDescriptorSetLayout welkin_vulkan_volume_descriptor_set_layout(const WelkinVulkanVolume* object) {
  return object == nullptr ? VkDescriptorSetLayout{VK_NULL_HANDLE} : object->sets.layout;
}

VkDescriptorSet welkin_vulkan_volume_descriptor_set(const WelkinVulkanVolume* object, uint32_t frame) {
  return object == nullptr || frame >= object->frame_count ? VkDescriptorSet{VK_NULL_HANDLE} : object->sets.sets[frame];
}

WelkinResult welkin_vulkan_volume_memory(const WelkinVulkanVolume* object, WelkinVulkanMemory* memory) {
  if (const auto r = nonNull(__func__, {{"object", object}})) return r;
  if (const auto r = core::sized(__func__, "memory", memory)) return r;
  WelkinVulkanMemory out{};
  out.images = object->image_bytes + object->cuts.bytes + object->relight.probes.bytes + object->relight.relit.bytes;
  out.staging = object->staging.bytes + object->relight.staging.bytes;
  core::give(out, memory);
  return WELKIN_OK;
}
