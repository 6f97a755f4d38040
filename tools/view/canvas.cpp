// SPDX-License-Identifier: Apache-2.0
#include "view/canvas.h"

namespace welkin::view {
namespace {

constexpr render::ImageUse kBlitTo{VK_PIPELINE_STAGE_2_BLIT_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
constexpr render::ImageUse kBlitFrom{VK_PIPELINE_STAGE_2_BLIT_BIT, VK_ACCESS_2_TRANSFER_READ_BIT,
                                     VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};

bool isOfSize(const std::unique_ptr<render::Image>& image, uint32_t width, uint32_t height) {
  return image && image->extent().width == width && image->extent().height == height;
}

VkBufferImageCopy wholeOf(const render::Image& image) {
  VkBufferImageCopy region{};
  region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  region.imageExtent = {image.extent().width, image.extent().height, 1};
  return region;
}

}  // namespace

Canvas::Canvas(render::VulkanDevice& device) : device_(device), panels_(device, kFormat) {}

void Canvas::resize(uint32_t width, uint32_t height, uint32_t picture_width, uint32_t picture_height) {
  if (!isOfSize(image_, width, height))
    image_ = std::make_unique<render::Image>(device_, kFormat, VkExtent2D{width, height},
                                             VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                                                 VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_SAMPLED_BIT);
  if (isOfSize(picture_, picture_width, picture_height)) return;
  picture_ = std::make_unique<render::Image>(
      device_, kFormat, VkExtent2D{picture_width, picture_height},
      VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_SAMPLED_BIT);
  staging_ = std::make_unique<render::Buffer>(device_, VkDeviceSize{4} * picture_width * picture_height,
                                              VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
}

void Canvas::record(VkCommandBuffer commands, const render::Picture& picture, uint32_t width, uint32_t height,
                    const ImDrawData& panels) {
  resize(width, height, picture.width, picture.height);
  auto* out = staging_->as<uint8_t>();
  for (std::size_t i = 0; i < std::size_t{picture.width} * picture.height; ++i) {
    for (std::size_t c = 0; c < 3; ++c) out[4 * i + c] = picture.rgb[3 * i + c];
    out[4 * i + 3] = 255;
  }
  picture_->use(commands, render::kCopiedTo, true);
  const VkBufferImageCopy region = wholeOf(*picture_);
  vkCmdCopyBufferToImage(commands, staging_->handle(), picture_->handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1,
                         &region);
  picture_->use(commands, kBlitFrom);
  image_->use(commands, kBlitTo, true);
  VkImageBlit blit{};
  blit.srcSubresource = blit.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  blit.srcOffsets[1] = {static_cast<int32_t>(picture.width), static_cast<int32_t>(picture.height), 1};
  blit.dstOffsets[1] = {static_cast<int32_t>(width), static_cast<int32_t>(height), 1};
  const bool whole = picture.width == width && picture.height == height;
  vkCmdBlitImage(commands, picture_->handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, image_->handle(),
                 VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &blit, whole ? VK_FILTER_NEAREST : VK_FILTER_LINEAR);
  panels_.record(commands, *image_, panels);
}

render::Picture Canvas::read(const render::Picture& picture, uint32_t width, uint32_t height,
                             const ImDrawData& panels) {
  const render::Buffer readback(device_, VkDeviceSize{4} * width * height, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
  device_.execute([&](VkCommandBuffer commands) {
    record(commands, picture, width, height, panels);
    image_->use(commands, render::kCopiedFrom);
    const VkBufferImageCopy region = wholeOf(*image_);
    vkCmdCopyImageToBuffer(commands, image_->handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, readback.handle(), 1,
                           &region);
    render::recordHostRead(commands, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT);
  });
  render::Picture result{width, height, {}};
  const auto* rgba = readback.as<uint8_t>();
  result.rgb.reserve(std::size_t{3} * width * height);
  for (std::size_t i = 0; i < std::size_t{width} * height; ++i)
    for (std::size_t c = 0; c < 3; ++c) result.rgb.push_back(rgba[4 * i + c]);
  return result;
}

}  // namespace welkin::view
