// SPDX-License-Identifier: Apache-2.0
// The C interface of welkin_vulkan.h.
#include <cstring>
#include <iterator>
#include <memory>
#include <new>

#include "vulkan/constants.h"
#include "vulkan/descriptors.h"
#include "vulkan/dome_pipeline.h"
#include "vulkan/memory.h"
#include "vulkan/mips.h"
#include "vulkan/modes_map.h"

namespace welkin::vulkan {

struct Frame {
  uint32_t cubemap[2] = {};  ///< indices of the cubemaps in its descriptor set
  bool updated = false;
};

constexpr uint32_t kStars = 2;  ///< index of the image after the two gradients
constexpr uint32_t kModes = 3;
constexpr uint32_t kFixed = 4;  ///< number of images before the cubemaps

}  // namespace welkin::vulkan

struct WelkinVulkanSky {
  welkin::vulkan::Device device;
  welkin::vulkan::SkyShape shape;
  welkin::vulkan::Descriptors descriptors;
  welkin::vulkan::DomePipeline dome;
  std::unique_ptr<welkin::vulkan::Image[]> images;  ///< gradients, stars, modes, cubemaps; black if missing
  uint32_t image_count = 0;
  uint32_t cubemap_count = 0;  ///< cubemaps in the file
  WelkinVulkanAllocation image_memory{};
  VkDeviceSize image_bytes = 0;
  welkin::vulkan::MappedBuffer staging;
  welkin::vulkan::MappedBuffer uniforms;
  VkDeviceSize slice_bytes = 0;  ///< distance between the constants of two frames
  uint32_t frame_count = 0;
  welkin::vulkan::Frame frames[WELKIN_VULKAN_MAX_FRAMES_IN_FLIGHT];
  bool upload_recorded = false;
};

namespace welkin::vulkan {
namespace {

VkDeviceSize alignUp(VkDeviceSize bytes, VkDeviceSize to) {
  return (bytes + to - 1) / to * to;
}

void copyGradient(const WelkinGradient& gradient, unsigned char* to) {
  const size_t texels = size_t{gradient.width} * gradient.height;
  for (size_t i = 0; i < texels; ++i) {
    const float rgba[4] = {gradient.rgb[3 * i], gradient.rgb[3 * i + 1], gradient.rgb[3 * i + 2], 1.0F};
    std::memcpy(to + i * sizeof(rgba), rgba, sizeof(rgba));
  }
}

/// Number of images: two gradients, the stars, the modes, then the cubemaps. A missing one is replaced by a black
/// image.
uint32_t imageCount(const WelkinSkyInfo& info) {
  return kFixed + (info.cubemap_count > 0 ? info.cubemap_count : 1);
}

constexpr VkFormat kVulkanFormats[] = {VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_E5B9G9R9_UFLOAT_PACK32,
                                       VK_FORMAT_B10G11R11_UFLOAT_PACK32};
static_assert(std::size(kVulkanFormats) == format::kCubemapFormats);

Image imageOf(const WelkinSkyInfo& info, const WelkinGradients& gradients, const WelkinStars& stars,
              const WelkinModes& modes, uint32_t index) {
  if (index == kModes) return modesImage(modes);
  Image image;
  if (index == kStars) {
    image.extent = {stars.width > 0 ? stars.width : 1, stars.height > 0 ? stars.height : 1};
    image.layers = 1;
    image.format = VK_FORMAT_R8G8B8A8_SRGB;
    image.texel_bytes = 4;
    return image;
  }
  if (index < kStars) {
    const WelkinGradient& gradient = index == 0 ? gradients.sun : gradients.anti;
    image.extent = {gradient.width, gradient.height};
    image.layers = 1;
    image.format = VK_FORMAT_R32G32B32A32_SFLOAT;
    image.texel_bytes = 16;
    return image;
  }
  const uint32_t edge = info.cubemap_count > 0 ? info.cubemap_size : 1;
  image.extent = {edge, edge};
  image.layers = 6;
  const auto format = static_cast<format::CubemapFormat>(info.cubemap_format);
  image.format = kVulkanFormats[info.cubemap_format];
  image.texel_bytes = format::texelBytes(format);
  image.mips = mipCount(edge);
  image.blits_mips = format == format::CubemapFormat::rgba16f;  // devices need not be able to write other formats
  return image;
}

WelkinResult createSkyImages(WelkinVulkanSky& o, const WelkinVulkanCreateInfo& create, const WelkinSky* sky,
                             WelkinMessage* message) {
  WelkinSkyInfo info;
  WelkinGradients gradients;
  WelkinStars stars;
  WelkinModes modes;
  if (welkin_sky_info(sky, &info) != WELKIN_OK || welkin_sky_gradients(sky, &gradients) != WELKIN_OK ||
      welkin_sky_stars(sky, &stars) != WELKIN_OK || welkin_sky_modes(sky, &modes) != WELKIN_OK ||
      welkin_sky_luminance(sky, &o.shape.luminance) != WELKIN_OK)
    return fail(message, WELKIN_ERROR_ARGUMENT, "the sky is null");
  constexpr VkFormatFeatureFlags kFilter = VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT | VK_FORMAT_FEATURE_TRANSFER_DST_BIT |
                                           VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT;
  if (const auto r = checkFormat(o.device, kVulkanFormats[info.cubemap_format], kFilter, "cubemaps", message)) return r;
  const uint32_t sizes[4] = {gradients.sun.width, gradients.sun.height, gradients.anti.width, gradients.anti.height};
  std::memcpy(o.shape.gradient_size, sizes, sizeof(sizes));
  o.shape.gradient_delta = gradients.delta;
  o.shape.stars = stars;
  o.shape.stars.rgba8 = nullptr;  // the sky may be closed after this call
  o.shape.modes = modes;
  o.shape.modes.texels = nullptr;
  o.cubemap_count = info.cubemap_count;
  o.image_count = imageCount(info);
  o.images.reset(new (std::nothrow) Image[o.image_count]);
  if (o.images == nullptr) return fail(message, WELKIN_ERROR_MEMORY, "out of host memory");
  for (uint32_t i = 0; i < o.image_count; ++i) o.images[i] = imageOf(info, gradients, stars, modes, i);
  if (create.images != nullptr && create.image_count != o.image_count)
    return fail(message, WELKIN_ERROR_ARGUMENT, "image_count is %u, the sky has %u", create.image_count, o.image_count);
  for (uint32_t i = 0; create.images != nullptr && i < o.image_count; ++i) {
    o.images[i].image = create.images[i];
    o.images[i].borrowed = true;
  }
  if (const auto r = createImages(o.device, o.images.get(), o.image_count, o.image_memory, o.image_bytes, message))
    return r;

  VkDeviceSize bytes = 0;
  const VkDeviceSize alignment = alignUp(o.device.properties.limits.optimalBufferCopyOffsetAlignment, 16);
  for (uint32_t i = 0; i < o.image_count; ++i) {
    bytes = alignUp(bytes, alignment);
    o.images[i].staging_offset = bytes;
    bytes += o.images[i].stagedBytes();
  }
  if (const auto r =
          createMapped(o.device, bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, "welkin staging", o.staging, message))
    return r;
  copyGradient(gradients.sun, o.staging.mapped + o.images[0].staging_offset);
  copyGradient(gradients.anti, o.staging.mapped + o.images[1].staging_offset);
  std::memset(o.staging.mapped + o.images[kStars].staging_offset, 0, o.images[kStars].stagedBytes());
  if (stars.width > 0)
    std::memcpy(o.staging.mapped + o.images[kStars].staging_offset, stars.rgba8, o.images[kStars].stagedBytes());
  copyModes(modes, o.staging.mapped + o.images[kModes].staging_offset);
  if (info.cubemap_count == 0)
    std::memset(o.staging.mapped + o.images[kFixed].staging_offset, 0, o.images[kFixed].stagedBytes());
  for (uint32_t i = 0; i < info.cubemap_count; ++i) {
    WelkinCubemap cubemap;
    const Image& image = o.images[kFixed + i];
    if (welkin_sky_cubemap(sky, i, &cubemap) != WELKIN_OK || cubemap.bytes != image.mipBytes(0))
      return fail(message, WELKIN_ERROR_CONTENT, "cubemap %u cannot be read", i);
    std::memcpy(o.staging.mapped + image.staging_offset, cubemap.texels, cubemap.bytes);
    if (!image.blits_mips && !makeMips(static_cast<format::CubemapFormat>(cubemap.format), cubemap.size,
                                       static_cast<const unsigned char*>(cubemap.texels),
                                       o.staging.mapped + image.staging_offset + image.mipBytes(0)))
      return fail(message, WELKIN_ERROR_MEMORY, "out of host memory");
  }
  return WELKIN_OK;
}

void selectCubemaps(WelkinVulkanSky& o, uint32_t frame, uint32_t first, uint32_t second) {
  writeCubemaps(o.device, o.descriptors, frame, o.images[kFixed + first].view, o.images[kFixed + second].view);
  o.frames[frame].cubemap[0] = first;
  o.frames[frame].cubemap[1] = second;
}

/// Whether a sample has as many modes as this sky, or none.
bool hasModesOf(const WelkinVulkanSky& o, const WelkinSkySample& sample) {
  return sample.mode_count == 0 || sample.mode_count == o.shape.modes.count;
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

using namespace welkin::vulkan;

WelkinResult welkin_vulkan_create(const WelkinVulkanCreateInfo* info, const WelkinSky* sky, WelkinVulkanSky** out,
                                  WelkinMessage* message) {
  if (out == nullptr) return fail(message, WELKIN_ERROR_ARGUMENT, "out is null");
  *out = nullptr;
  if (info == nullptr || sky == nullptr) return fail(message, WELKIN_ERROR_ARGUMENT, "info or sky is null");
  if (info->struct_size != sizeof(WelkinVulkanCreateInfo))
    return fail(message, WELKIN_ERROR_ARGUMENT, "struct_size is %u, must be %zu", info->struct_size,
                sizeof(WelkinVulkanCreateInfo));
  auto* object = new (std::nothrow) WelkinVulkanSky;
  if (object == nullptr) return fail(message, WELKIN_ERROR_MEMORY, "out of host memory");
  if (const auto result = openDevice(*info, object->device, message)) {
    delete object;  // some functions may be missing, and nothing has been created
    return result;
  }
  if (const auto result = create(*object, *info, sky, message)) {
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
  if (object == nullptr || commands == nullptr || object->upload_recorded || object->staging.buffer == VK_NULL_HANDLE)
    return WELKIN_ERROR_ARGUMENT;
  recordImageUpload(object->device, commands, object->staging.buffer, object->images.get(), object->image_count);
  object->upload_recorded = true;
  return WELKIN_OK;
}

void welkin_vulkan_free_staging(WelkinVulkanSky* object) {
  if (object != nullptr) destroy(object->device, object->staging);
}

WelkinResult welkin_vulkan_update(WelkinVulkanSky* object, uint32_t frame, const WelkinSkySample* sample) {
  if (object == nullptr || sample == nullptr || frame >= object->frame_count) return WELKIN_ERROR_ARGUMENT;
  const uint32_t first = sample->cubemap[0];
  const uint32_t second = sample->cubemap[1];
  const uint32_t count = object->image_count - kFixed;
  if (first >= count || second >= count || sample->coefficient_count > WELKIN_MAX_COEFFICIENTS ||
      !hasModesOf(*object, *sample) || !(sample->time_h >= 0.0 && sample->time_h < 24.0))
    return WELKIN_ERROR_ARGUMENT;
  const WelkinSkyConstants constants = packConstants(object->shape, *sample);
  std::memcpy(object->uniforms.mapped + frame * object->slice_bytes, &constants, sizeof(constants));
  Frame& f = object->frames[frame];
  if (f.cubemap[0] != first || f.cubemap[1] != second) selectCubemaps(*object, frame, first, second);
  f.updated = true;
  return WELKIN_OK;
}

WelkinResult welkin_vulkan_update_ambient(WelkinVulkanSky* object, uint32_t frame, const WelkinSkySample* blended) {
  if (object == nullptr || blended == nullptr || frame >= object->frame_count || !object->frames[frame].updated ||
      blended->coefficient_count > WELKIN_MAX_COEFFICIENTS || !hasModesOf(*object, *blended))
    return WELKIN_ERROR_ARGUMENT;
  WelkinSkyConstants constants{};
  packAmbient(*blended, constants);
  unsigned char* slice = object->uniforms.mapped + frame * object->slice_bytes;  // never read: reading it is slow
  std::memcpy(slice + offsetof(WelkinSkyConstants, moon) + offsetof(WelkinFloat4, w), &constants.moon.w, sizeof(float));
  constexpr size_t kFirst = offsetof(WelkinSkyConstants, ambient_sh);  // up to mode_texels, fixed for all hours
  std::memcpy(slice + kFirst, constants.ambient_sh, offsetof(WelkinSkyConstants, mode_texels) - kFirst);
  return WELKIN_OK;
}

WelkinResult welkin_vulkan_image_infos(const WelkinSky* sky, uint32_t* count, VkImageCreateInfo* infos) {
  WelkinSkyInfo info;
  WelkinGradients gradients;
  WelkinStars stars;
  WelkinModes modes;
  if (count == nullptr || welkin_sky_info(sky, &info) != WELKIN_OK ||
      welkin_sky_gradients(sky, &gradients) != WELKIN_OK || welkin_sky_stars(sky, &stars) != WELKIN_OK ||
      welkin_sky_modes(sky, &modes) != WELKIN_OK)
    return WELKIN_ERROR_ARGUMENT;
  const uint32_t total = imageCount(info);
  for (uint32_t i = 0; infos != nullptr && i < total && i < *count; ++i)
    infos[i] = imageInfo(imageOf(info, gradients, stars, modes, i));
  *count = total;
  return WELKIN_OK;
}

WelkinResult welkin_vulkan_draw_dome(const WelkinVulkanSky* object, VkCommandBuffer commands, uint32_t frame,
                                     const WelkinVulkanView* view) {
  if (object == nullptr || commands == nullptr || view == nullptr || frame >= object->frame_count ||
      !object->frames[frame].updated || !object->upload_recorded)
    return WELKIN_ERROR_ARGUMENT;
  const bool fisheye = view->projection == WELKIN_VULKAN_FISHEYE;
  if ((!fisheye && view->projection != WELKIN_VULKAN_PERSPECTIVE) || (fisheye && !(view->aspect > 0.0F)) ||
      !(view->depth >= 0.0F && view->depth <= 1.0F))
    return WELKIN_ERROR_ARGUMENT;
  if (view->source != WELKIN_VULKAN_ANALYTIC && (view->source != WELKIN_VULKAN_CUBEMAP || object->cubemap_count == 0))
    return WELKIN_ERROR_ARGUMENT;
  welkin::passes::DomePush push{};
  std::memcpy(push.inverse_view_projection, view->inverse_view_projection, sizeof(push.inverse_view_projection));
  if (fisheye) {
    push.fisheye_scale[0] = view->aspect > 1.0F ? view->aspect : 1.0F;
    push.fisheye_scale[1] = view->aspect < 1.0F ? 1.0F / view->aspect : 1.0F;
    push.flags |= WELKIN_DOME_FISHEYE;
  }
  const float opacity = view->opacity;
  if (!(opacity >= 0.0F && opacity <= 1.0F)) return WELKIN_ERROR_ARGUMENT;
  if (opacity > 0.0F && opacity < 1.0F && !object->dome.blends) return WELKIN_ERROR_DEVICE;
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
  if (object == nullptr || memory == nullptr) return WELKIN_ERROR_ARGUMENT;
  *memory = {object->image_bytes, object->uniforms.bytes, object->staging.bytes};
  return WELKIN_OK;
}
