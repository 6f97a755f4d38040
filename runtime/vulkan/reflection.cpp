// SPDX-License-Identifier: Apache-2.0
// The C interface of welkin_vulkan_reflection.h.
#include <algorithm>
#include <bit>
#include <cstring>
#include <new>

#include "materials.h"
#include "passes/reflection_filter.h"
#include "vulkan/barriers.h"
#include "vulkan/reflection_object.h"
#include "vulkan/sky_object.h"

namespace welkin::vulkan {
namespace {

using core::nonNull;
using core::refuse;

constexpr VkPipelineStageFlags2 kFilters = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;

/// Records a barrier for the whole image: `before` the passes, or after them.
void recordImageBarrier(const WelkinVulkanReflection& o, VkCommandBuffer commands, bool before) {
  constexpr VkImageLayout kRead = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
  VkImageMemoryBarrier2 barrier =
      before ? imageBarrier(o.image, o.is_filled ? kShaders : VK_PIPELINE_STAGE_2_NONE, VK_ACCESS_2_NONE,
                            o.is_filled ? kRead : VK_IMAGE_LAYOUT_UNDEFINED, kFilters,
                            VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, VK_IMAGE_LAYOUT_GENERAL)
             : imageBarrier(o.image, kFilters, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, VK_IMAGE_LAYOUT_GENERAL, kShaders,
                            VK_ACCESS_2_SHADER_SAMPLED_READ_BIT, kRead);
  barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, o.mips, 0, 6};
  recordBarriers(o.device, commands, &barrier, 1);
}

/// Filters faces of one mip.
void recordFaces(const WelkinVulkanReflection& o, VkCommandBuffer commands, VkDescriptorSet sky, uint32_t mip,
                 uint32_t face, uint32_t faces) {
  const auto& fn = o.device.fn;
  const VkDescriptorSet sets[2] = {sky, o.written.sets[mip]};
  fn.CmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, o.pipeline_layout, 0, 2, sets, 0, nullptr);
  const uint32_t edge = o.size >> mip;
  const double power = f64::powerOfGloss(f64::glossOfMip(mip, o.mips));
  const passes::ReflectionPush push{static_cast<int32_t>(edge), static_cast<int32_t>(face), static_cast<float>(power)};
  fn.CmdPushConstants(commands, o.pipeline_layout, VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof push, &push);
  fn.CmdDispatch(commands, (edge * edge + WELKIN_REFLECTION_GROUP - 1) / WELKIN_REFLECTION_GROUP, 1, faces);
}

/// Filters the next `count` pieces.
void recordPieces(const WelkinVulkanReflection& o, VkCommandBuffer commands, VkDescriptorSet sky, uint32_t count) {
  recordImageBarrier(o, commands, true);
  o.device.fn.CmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, o.pipeline);
  for (uint32_t piece = o.next, end = o.next + count; piece < end;) {
    const uint32_t mip = piece / 6 % o.mips, face = piece % 6, faces = std::min(6 - face, end - piece);
    recordFaces(o, commands, sky, mip, face, faces);
    piece += faces;
  }
  recordImageBarrier(o, commands, false);
}

}  // namespace
}  // namespace welkin::vulkan

namespace core = welkin::core;
using namespace welkin::vulkan;

WelkinResult welkin_vulkan_reflection_create(const WelkinVulkanCreateInfo* info, const WelkinVulkanSky* sky,
                                             uint32_t size, WelkinVulkanReflection** out, WelkinMessage* message) {
  if (out == nullptr) return fail(message, WELKIN_ERROR_ARGUMENT, "out is null");
  *out = nullptr;
  if (nonNull(__func__, {{"sky", sky}}) != WELKIN_OK || core::sized(__func__, "info", info) != WELKIN_OK)
    return fail(message, WELKIN_ERROR_ARGUMENT, "%s", welkin_argument_error());
  if (!std::has_single_bit(size) || size < WELKIN_REFLECTION_LEAST_SIZE || size > WELKIN_REFLECTION_MOST_SIZE)
    return fail(message, WELKIN_ERROR_ARGUMENT, "size is %u, must be a power of two from %d to %d", size,
                WELKIN_REFLECTION_LEAST_SIZE, WELKIN_REFLECTION_MOST_SIZE);
  const WelkinVulkanCreateInfo given = core::take(*info);
  auto* object = new (std::nothrow) WelkinVulkanReflection;
  if (object == nullptr) return fail(message, WELKIN_ERROR_MEMORY, "out of host memory");
  if (const auto result = openDevice(given, object->device, message)) {
    delete object;  // some functions may be missing, and nothing has been created
    return result;
  }
  object->size = size;
  object->mips = static_cast<uint32_t>(std::bit_width(size / kReflectionLastEdge));
  if (const auto result = createReflection(*object, sky->descriptors.layout, given.pipeline_cache, message)) {
    welkin_vulkan_reflection_destroy(object);
    return result;
  }
  *out = object;
  return WELKIN_OK;
}

void welkin_vulkan_reflection_destroy(WelkinVulkanReflection* object) {
  if (object == nullptr) return;
  destroy(*object);
  delete object;
}

WelkinResult welkin_vulkan_reflection_record(WelkinVulkanReflection* object, VkCommandBuffer commands,
                                             const WelkinVulkanSky* sky, uint32_t frame, uint32_t budget,
                                             uint32_t* left) {
  if (const auto r = nonNull(__func__, {{"object", object}, {"commands", commands}, {"sky", sky}})) return r;
  if (frame >= sky->frame_count || !sky->frames[frame].updated)
    return refuse(__func__, "welkin_vulkan_update was not called for frame %u", frame);
  if (!sky->upload_recorded) return refuse(__func__, "welkin_vulkan_record_upload was not called");
  WelkinVulkanReflection& o = *object;
  std::array<std::byte, kDomeBytes> dome;
  std::memcpy(dome.data(), sky->uniforms.mapped + frame * sky->slice_bytes, dome.size());
  if (!o.is_filled || dome != o.dome || sky != o.sky) o.left = o.pieces();
  o.dome = dome;
  o.sky = sky;
  const uint32_t count = o.is_filled ? std::min(budget, o.left) : o.left;
  if (count > 0) recordPieces(o, commands, sky->descriptors.sets[frame], count);
  o.next = (o.next + count) % o.pieces();
  o.left -= count;
  o.is_filled = true;
  if (left != nullptr) *left = o.left;
  return WELKIN_OK;
}

uint32_t welkin_vulkan_reflection_pieces(const WelkinVulkanReflection* object) {
  return object == nullptr ? 0 : object->pieces();
}

VkDescriptorSetLayout welkin_vulkan_reflection_descriptor_set_layout(const WelkinVulkanReflection* object) {
  return object == nullptr ? VkDescriptorSetLayout{VK_NULL_HANDLE} : object->read.layout;
}

VkDescriptorSet welkin_vulkan_reflection_descriptor_set(const WelkinVulkanReflection* object) {
  return object == nullptr ? VkDescriptorSet{VK_NULL_HANDLE} : object->read.sets[0];
}

WelkinResult welkin_vulkan_reflection_memory(const WelkinVulkanReflection* object, WelkinVulkanMemory* memory) {
  if (const auto r = nonNull(__func__, {{"object", object}})) return r;
  if (const auto r = core::sized(__func__, "memory", memory)) return r;
  WelkinVulkanMemory held{};
  held.images = object->bytes;
  core::give(held, memory);
  return WELKIN_OK;
}
