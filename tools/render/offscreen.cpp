// SPDX-License-Identifier: Apache-2.0
// Draws into a float image and reads it back.
#include "render/offscreen.h"

#include <algorithm>
#include <cstring>
#include <string>

#include "sky/error.h"

namespace welkin::tools {
namespace {

VkDeviceSize bytesFor(const VulkanDevice& device, uint32_t width, uint32_t height) {
  const uint32_t limit =
      std::min({device.properties().limits.maxImageDimension2D, device.properties().limits.maxFramebufferWidth,
                device.properties().limits.maxFramebufferHeight});
  if (width < 1 || height < 1 || width > limit || height > limit)
    throw Error(ExitStatus::usage, "a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                                       ": each side must be 1 to " + std::to_string(limit) + " on this device");
  return VkDeviceSize{16} * width * height;
}

void recordBarrier(VkCommandBuffer commands, VkImageMemoryBarrier2 image) {
  image.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
  image.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  image.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  image.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  VkDependencyInfo dependency{};
  dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
  dependency.imageMemoryBarrierCount = 1;
  dependency.pImageMemoryBarriers = &image;
  vkCmdPipelineBarrier2(commands, &dependency);
}

void recordHostRead(VkCommandBuffer commands) {
  VkMemoryBarrier2 memory{};
  memory.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
  memory.srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
  memory.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
  memory.dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT;
  memory.dstAccessMask = VK_ACCESS_2_HOST_READ_BIT;
  VkDependencyInfo dependency{};
  dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
  dependency.memoryBarrierCount = 1;
  dependency.pMemoryBarriers = &memory;
  vkCmdPipelineBarrier2(commands, &dependency);
}

}  // namespace

Offscreen::Offscreen(VulkanDevice& device, uint32_t width, uint32_t height)
    : device_(device),
      width_(width),
      height_(height),
      readback_(device, bytesFor(device, width, height), VK_BUFFER_USAGE_TRANSFER_DST_BIT) {
  createImage();
}

Offscreen::~Offscreen() {
  vkDestroyImageView(device_.device(), view_, nullptr);
  vkDestroyImage(device_.device(), image_, nullptr);
  vkFreeMemory(device_.device(), memory_, nullptr);
}

void Offscreen::createImage() {
  VkImageCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = kFormat;
  info.extent = {width_, height_, 1};
  info.mipLevels = 1;
  info.arrayLayers = 1;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  require(vkCreateImage(device_.device(), &info, nullptr, &image_), "vkCreateImage");
  VkMemoryRequirements needs;
  vkGetImageMemoryRequirements(device_.device(), image_, &needs);
  VkMemoryAllocateInfo allocate{};
  allocate.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
  allocate.allocationSize = needs.size;
  allocate.memoryTypeIndex = device_.memoryType(needs.memoryTypeBits, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  require(vkAllocateMemory(device_.device(), &allocate, nullptr, &memory_), "vkAllocateMemory");
  require(vkBindImageMemory(device_.device(), image_, memory_, 0), "vkBindImageMemory");
  VkImageViewCreateInfo view{};
  view.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
  view.image = image_;
  view.viewType = VK_IMAGE_VIEW_TYPE_2D;
  view.format = kFormat;
  view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  require(vkCreateImageView(device_.device(), &view, nullptr, &view_), "vkCreateImageView");
}

FloatImage Offscreen::render(const std::function<void(VkCommandBuffer)>& draw) {
  device_.execute([&](VkCommandBuffer commands) {
    VkImageMemoryBarrier2 to_draw{};
    to_draw.dstStageMask = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
    to_draw.dstAccessMask = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
    to_draw.oldLayout = VK_IMAGE_LAYOUT_UNDEFINED;
    to_draw.newLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    to_draw.image = image_;
    recordBarrier(commands, to_draw);

    VkRenderingAttachmentInfo colour{};
    colour.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
    colour.imageView = view_;
    colour.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    colour.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    colour.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    VkRenderingInfo rendering{};
    rendering.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
    rendering.renderArea.extent = {width_, height_};
    rendering.layerCount = 1;
    rendering.colorAttachmentCount = 1;
    rendering.pColorAttachments = &colour;
    vkCmdBeginRendering(commands, &rendering);
    const VkViewport viewport{0.0F, 0.0F, static_cast<float>(width_), static_cast<float>(height_), 0.0F, 1.0F};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &rendering.renderArea);
    draw(commands);
    vkCmdEndRendering(commands);

    VkImageMemoryBarrier2 to_copy{};
    to_copy.srcStageMask = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
    to_copy.srcAccessMask = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
    to_copy.dstStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
    to_copy.dstAccessMask = VK_ACCESS_2_TRANSFER_READ_BIT;
    to_copy.oldLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    to_copy.newLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    to_copy.image = image_;
    recordBarrier(commands, to_copy);
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {width_, height_, 1};
    vkCmdCopyImageToBuffer(commands, image_, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, readback_.handle(), 1, &region);
    recordHostRead(commands);
  });
  FloatImage image{width_, height_, std::vector<float>(std::size_t{4} * width_ * height_)};
  std::memcpy(image.rgba.data(), readback_.as<float>(), image.rgba.size() * sizeof(float));
  return image;
}

}  // namespace welkin::tools
