// SPDX-License-Identifier: Apache-2.0
#include "vulkan/sky_images.h"

#include <cstring>
#include <iterator>
#include <new>

#include "vulkan/mips.h"
#include "vulkan/modes_map.h"

namespace welkin::vulkan {
namespace {

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

}  // namespace

WelkinResult createSkyImages(WelkinVulkanSky& o, const WelkinVulkanCreateInfo& create, const WelkinSky* sky,
                             WelkinMessage* message) {
  WelkinSkyInfo info;
  WelkinGradients gradients;
  WelkinStars stars;
  WelkinModes modes;
  if (welkin_sky_info(sky, &info) != WELKIN_OK || welkin_sky_gradients(sky, &gradients) != WELKIN_OK ||
      welkin_sky_stars(sky, &stars) != WELKIN_OK || welkin_sky_modes(sky, &modes) != WELKIN_OK ||
      core::shapeOf(sky, o.shape) != WELKIN_OK)
    return fail(message, WELKIN_ERROR_ARGUMENT, "the sky is null");
  constexpr VkFormatFeatureFlags kFilter = VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT | VK_FORMAT_FEATURE_TRANSFER_DST_BIT |
                                           VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT;
  if (const auto r = checkFormat(o.device, kVulkanFormats[info.cubemap_format], kFilter, "cubemaps", message)) return r;
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

}  // namespace welkin::vulkan

WelkinResult welkin_vulkan_image_infos(const WelkinSky* sky, uint32_t* count, VkImageCreateInfo* infos) {
  WelkinSkyInfo info;
  WelkinGradients gradients;
  WelkinStars stars;
  WelkinModes modes;
  if (const auto r = welkin::core::nonNull(__func__, {{"sky", sky}, {"count", count}})) return r;
  if (welkin_sky_info(sky, &info) != WELKIN_OK || welkin_sky_gradients(sky, &gradients) != WELKIN_OK ||
      welkin_sky_stars(sky, &stars) != WELKIN_OK || welkin_sky_modes(sky, &modes) != WELKIN_OK)
    return WELKIN_ERROR_ARGUMENT;
  using namespace welkin::vulkan;
  const uint32_t total = imageCount(info);
  for (uint32_t i = 0; infos != nullptr && i < total && i < *count; ++i)
    infos[i] = imageInfo(imageOf(info, gradients, stars, modes, i));
  *count = total;
  return WELKIN_OK;
}
