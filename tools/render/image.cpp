// SPDX-License-Identifier: Apache-2.0
// Creates images and records their barriers.
#include "render/image.h"

#include <algorithm>
#include <string>

#include "sky/base/error.h"

namespace welkin::render {

Image::Image(const VulkanDevice& device, VkFormat format, VkExtent2D extent, VkImageUsageFlags usage)
    : device_(device.device()), format_(format), extent_(extent) {
  const VkPhysicalDeviceLimits& limits = device.properties().limits;
  const uint32_t limit =
      std::min({limits.maxImageDimension2D, limits.maxFramebufferWidth, limits.maxFramebufferHeight});
  if (extent.width < 1 || extent.height < 1 || extent.width > limit || extent.height > limit)
    throw base::Error(base::ExitStatus::usage, "a picture of " + std::to_string(extent.width) + "x" +
                                                   std::to_string(extent.height) + ": each side must be 1 to " +
                                                   std::to_string(limit) + " on this device");
  try {
    create(device, usage);
  } catch (...) {
    destroy();
    throw;
  }
}

void Image::destroy() {
  vkDestroyImageView(device_, view_, nullptr);
  vkDestroyImage(device_, image_, nullptr);
  vkFreeMemory(device_, memory_, nullptr);
}

VkImageAspectFlags Image::aspect() const {
  return format_ == VK_FORMAT_D32_SFLOAT ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

void Image::create(const VulkanDevice& device, VkImageUsageFlags usage) {
  VkImageCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = format_;
  info.extent = {extent_.width, extent_.height, 1};
  info.mipLevels = 1;
  info.arrayLayers = 1;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.usage = usage;
  require(vkCreateImage(device_, &info, nullptr, &image_), "vkCreateImage");
  VkMemoryRequirements needs;
  vkGetImageMemoryRequirements(device_, image_, &needs);
  VkMemoryAllocateInfo allocate{};
  allocate.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
  allocate.allocationSize = needs.size;
  allocate.memoryTypeIndex = device.memoryType(needs.memoryTypeBits, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  require(vkAllocateMemory(device_, &allocate, nullptr, &memory_), "vkAllocateMemory");
  require(vkBindImageMemory(device_, image_, memory_, 0), "vkBindImageMemory");
  VkImageViewCreateInfo view{};
  view.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
  view.image = image_;
  view.viewType = VK_IMAGE_VIEW_TYPE_2D;
  view.format = format_;
  view.subresourceRange = {aspect(), 0, 1, 0, 1};
  require(vkCreateImageView(device_, &view, nullptr, &view_), "vkCreateImageView");
}

void Image::use(VkCommandBuffer commands, const ImageUse& next, bool discard) {
  VkImageMemoryBarrier2 barrier{};
  barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
  barrier.srcStageMask = last_.stages;
  barrier.srcAccessMask = last_.access;
  barrier.dstStageMask = next.stages;
  barrier.dstAccessMask = next.access;
  barrier.oldLayout = discard ? VK_IMAGE_LAYOUT_UNDEFINED : last_.layout;
  barrier.newLayout = next.layout;
  barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image_;
  barrier.subresourceRange = {aspect(), 0, 1, 0, 1};
  VkDependencyInfo dependency{};
  dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
  dependency.imageMemoryBarrierCount = 1;
  dependency.pImageMemoryBarriers = &barrier;
  vkCmdPipelineBarrier2(commands, &dependency);
  last_ = next;
}

VkRenderingAttachmentInfo attachmentOf(const Image& image, VkImageLayout layout, VkAttachmentLoadOp load) {
  VkRenderingAttachmentInfo info{};
  info.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
  info.imageView = image.view();
  info.imageLayout = layout;
  info.loadOp = load;
  info.storeOp =
      layout == VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL ? VK_ATTACHMENT_STORE_OP_NONE : VK_ATTACHMENT_STORE_OP_STORE;
  return info;
}

}  // namespace welkin::render
