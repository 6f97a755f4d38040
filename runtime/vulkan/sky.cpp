// SPDX-License-Identifier: Apache-2.0
// The C interface of welkin_vulkan.h.
#include <cstring>
#include <new>

#include "vulkan/sky_images.h"

namespace welkin::vulkan {
namespace {

using core::nonNull;
using core::refuse;

void selectCubemaps(WelkinVulkanSky& o, uint32_t frame, uint32_t first, uint32_t second) {
  writeCubemaps(o.device, o.descriptors, frame, o.images[kFixed + first].view, o.images[kFixed + second].view);
  o.frames[frame].cubemap[0] = first;
  o.frames[frame].cubemap[1] = second;
}

/// WELKIN_OK if the sample can light this object's frame: it has the modes of the sky, or none.
WelkinResult checkFrame(const char* function, const WelkinVulkanSky* object, uint32_t frame, const char* name,
                        const WelkinSkySample* sample) {
  if (const auto r = nonNull(function, {{"object", object}})) return r;
  if (const auto r = core::checkSample(function, name, sample)) return r;
  if (frame >= object->frame_count)
    return refuse(function, "frame is %u, must be below frames_in_flight, %u", frame, object->frame_count);
  return core::checkModes(function, name, *sample, object->shape.modes.count, object->shape.modes.family);
}

WelkinResult createFrames(WelkinVulkanSky& o, WelkinMessage* message) {
  o.slice_bytes = alignUp(sizeof(WelkinSkyConstants), o.device.properties.limits.minUniformBufferOffsetAlignment);
  if (const auto r = createMapped(o.device, o.slice_bytes * o.frame_count, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT,
                                  "welkin constants", o.uniforms, message))
    return r;
  std::memset(o.uniforms.mapped, 0, o.slice_bytes * o.frame_count);
  for (uint32_t i = 0; i < o.frame_count; ++i) {
    const VkDescriptorBufferInfo slice{o.uniforms.buffer, i * o.slice_bytes, sizeof(WelkinSkyConstants)};
    writeFixedBindings(o.device, o.descriptors, i, slice, o.images[0].view, o.images[1].view, o.images[kStars].view,
                       o.images[kModes].view);
    selectCubemaps(o, i, 0, 0);
  }
  return WELKIN_OK;
}

WelkinResult create(WelkinVulkanSky& o, const WelkinVulkanCreateInfo& info, const WelkinSky* sky,
                    WelkinMessage* message) {
  if (info.frames_in_flight < 1 || info.frames_in_flight > WELKIN_VULKAN_MAX_FRAMES_IN_FLIGHT)
    return fail(message, WELKIN_ERROR_ARGUMENT, "frames_in_flight is %u, must be 1 to %d", info.frames_in_flight,
                WELKIN_VULKAN_MAX_FRAMES_IN_FLIGHT);
  o.frame_count = info.frames_in_flight;
  if (const auto r = createSkyImages(o, info, sky, message)) return r;
  if (const auto r = createDescriptors(o.device, o.frame_count, o.descriptors, message)) return r;
  if (const auto r = createFrames(o, message)) return r;
  return createDomePipeline(o.device, info, o.descriptors.layout, o.dome, message);
}

}  // namespace
}  // namespace welkin::vulkan

namespace core = welkin::core;
using namespace welkin::vulkan;

WelkinResult welkin_vulkan_create(const WelkinVulkanCreateInfo* info, const WelkinSky* sky, WelkinVulkanSky** out,
                                  WelkinMessage* message) {
  if (out == nullptr) return fail(message, WELKIN_ERROR_ARGUMENT, "out is null");
  *out = nullptr;
  if (nonNull(__func__, {{"sky", sky}}) != WELKIN_OK || welkin::core::sized(__func__, "info", info) != WELKIN_OK)
    return fail(message, WELKIN_ERROR_ARGUMENT, "%s", welkin_argument_error());
  const WelkinVulkanCreateInfo given = welkin::core::take(*info);
  auto* object = new (std::nothrow) WelkinVulkanSky;
  if (object == nullptr) return fail(message, WELKIN_ERROR_MEMORY, "out of host memory");
  if (const auto result = openDevice(given, object->device, message)) {
    delete object;  // some functions may be missing, and nothing has been created
    return result;
  }
  if (const auto result = create(*object, given, sky, message)) {
    welkin_vulkan_destroy(object);
    return result;
  }
  *out = object;
  return WELKIN_OK;
}

void welkin_vulkan_destroy(WelkinVulkanSky* object) {
  if (object == nullptr) return;
  const Device& device = object->device;
  destroy(device, object->dome);
  destroy(device, object->descriptors);
  destroy(device, object->uniforms);
  destroy(device, object->staging);
  for (uint32_t i = 0; i < object->image_count; ++i) destroy(device, object->images[i]);
  freeMemory(device, object->image_memory);
  delete object;
}

WelkinResult welkin_vulkan_record_upload(WelkinVulkanSky* object, VkCommandBuffer commands) {
  if (const auto r = nonNull(__func__, {{"object", object}, {"commands", commands}})) return r;
  if (object->upload_recorded) return refuse(__func__, "the upload was recorded before");
  if (object->staging.buffer == VK_NULL_HANDLE) return refuse(__func__, "the staging buffer was freed");
  recordImageUpload(object->device, commands, object->staging.buffer, object->images.get(), object->image_count);
  object->upload_recorded = true;
  return WELKIN_OK;
}

void welkin_vulkan_free_staging(WelkinVulkanSky* object) {
  if (object != nullptr) destroy(object->device, object->staging);
}

WelkinResult welkin_vulkan_update(WelkinVulkanSky* object, uint32_t frame, const WelkinSkySample* sample) {
  if (const auto r = checkFrame(__func__, object, frame, "sample", sample)) return r;
  const uint32_t first = sample->cubemap[0];
  const uint32_t second = sample->cubemap[1];
  const uint32_t count = object->image_count - kFixed;
  if (first >= count || second >= count)
    return refuse(__func__, "sample->cubemap is %u and %u, must be below the sky's %u", first, second, count);
  const WelkinSkyConstants constants = core::packConstants(object->shape, *sample);
  std::memcpy(object->uniforms.mapped + frame * object->slice_bytes, &constants, sizeof(constants));
  Frame& f = object->frames[frame];
  if (f.cubemap[0] != first || f.cubemap[1] != second) selectCubemaps(*object, frame, first, second);
  f.updated = true;
  return WELKIN_OK;
}

WelkinResult welkin_vulkan_update_ambient(WelkinVulkanSky* object, uint32_t frame, const WelkinSkySample* blended) {
  if (const auto r = checkFrame(__func__, object, frame, "blended", blended)) return r;
  if (!object->frames[frame].updated) return refuse(__func__, "welkin_vulkan_update was not called for this frame");
  core::replaceAmbient(*blended, object->uniforms.mapped + frame * object->slice_bytes);
  return WELKIN_OK;
}

WelkinResult welkin_vulkan_draw_dome(const WelkinVulkanSky* object, VkCommandBuffer commands, uint32_t frame,
                                     const WelkinVulkanView* view) {
  if (const auto r = nonNull(__func__, {{"object", object}, {"commands", commands}})) return r;
  if (const auto r = core::sized(__func__, "view", view)) return r;
  if (frame >= object->frame_count || !object->frames[frame].updated)
    return refuse(__func__, "welkin_vulkan_update was not called for frame %u", frame);
  if (!object->upload_recorded) return refuse(__func__, "welkin_vulkan_record_upload was not called");
  const bool fisheye = view->projection == WELKIN_VULKAN_FISHEYE;
  if (!fisheye && view->projection != WELKIN_VULKAN_PERSPECTIVE)
    return refuse(__func__, "view->projection is %d, must be 0 or 1", static_cast<int>(view->projection));
  if (fisheye && !(view->aspect > 0.0F))
    return refuse(__func__, "view->aspect is %g, must be above 0", double{view->aspect});
  if (!(view->depth >= 0.0F && view->depth <= 1.0F))
    return refuse(__func__, "view->depth is %g, must be 0 to 1", double{view->depth});
  if (view->source != WELKIN_VULKAN_ANALYTIC && (view->source != WELKIN_VULKAN_CUBEMAP || object->cubemap_count == 0))
    return refuse(__func__, "view->source is %d: %s", static_cast<int>(view->source),
                  view->source == WELKIN_VULKAN_CUBEMAP ? "the sky has no cubemaps" : "must be 0 or 1");
  const float opacity = view->opacity;
  if (!(opacity >= 0.0F && opacity <= 1.0F))
    return refuse(__func__, "view->opacity is %g, must be 0 to 1", double{opacity});
  if (opacity > 0.0F && opacity < 1.0F && !object->dome.blends) return WELKIN_ERROR_DEVICE;
  welkin::passes::DomePush push{};
  std::memcpy(push.inverse_view_projection, view->inverse_view_projection, sizeof(push.inverse_view_projection));
  if (fisheye) {
    push.fisheye_scale[0] = view->aspect > 1.0F ? view->aspect : 1.0F;
    push.fisheye_scale[1] = view->aspect < 1.0F ? 1.0F / view->aspect : 1.0F;
    push.flags |= WELKIN_DOME_FISHEYE;
  }
  push.depth = view->depth;
  if (view->discs != 0) push.flags |= WELKIN_DOME_DISCS;
  recordDome(object->device, object->dome, commands, object->descriptors.sets[frame], view->source, opacity, push);
  return WELKIN_OK;
}

VkDescriptorSetLayout welkin_vulkan_descriptor_set_layout(const WelkinVulkanSky* object) {
  return object == nullptr ? VK_NULL_HANDLE : object->descriptors.layout;
}

VkDescriptorSet welkin_vulkan_descriptor_set(const WelkinVulkanSky* object, uint32_t frame) {
  return object == nullptr || frame >= object->frame_count ? VK_NULL_HANDLE : object->descriptors.sets[frame];
}

WelkinResult welkin_vulkan_memory(const WelkinVulkanSky* object, WelkinVulkanMemory* memory) {
  if (const auto r = nonNull(__func__, {{"object", object}})) return r;
  if (const auto r = core::sized(__func__, "memory", memory)) return r;
  WelkinVulkanMemory held{};
  held.images = object->image_bytes;
  held.uniforms = object->uniforms.bytes;
  held.staging = object->staging.bytes;
  core::give(held, memory);
  return WELKIN_OK;
}
