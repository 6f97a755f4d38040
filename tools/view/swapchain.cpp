// SPDX-License-Identifier: Apache-2.0
#include "view/swapchain.h"

#include <algorithm>

#include "sky/base/error.h"

namespace welkin::view {
namespace {

constexpr render::ImageUse kShownFrom{VK_PIPELINE_STAGE_2_BLIT_BIT, VK_ACCESS_2_TRANSFER_READ_BIT,
                                      VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};

VkSurfaceFormatKHR formatOf(VkPhysicalDevice physical, VkSurfaceKHR surface) {
  uint32_t count = 0;
  render::require(vkGetPhysicalDeviceSurfaceFormatsKHR(physical, surface, &count, nullptr),
                  "vkGetPhysicalDeviceSurfaceFormatsKHR");
  std::vector<VkSurfaceFormatKHR> formats(count);
  render::require(vkGetPhysicalDeviceSurfaceFormatsKHR(physical, surface, &count, formats.data()),
                  "vkGetPhysicalDeviceSurfaceFormatsKHR");
  for (const VkSurfaceFormatKHR& format : formats)  // the canvas is encoded already
    if (format.format == VK_FORMAT_B8G8R8A8_UNORM || format.format == VK_FORMAT_R8G8B8A8_UNORM) return format;
  throw base::Error(base::ExitStatus::file, "Vulkan: the window shows no pictures of 8 bits a channel");
}

void barrier(VkCommandBuffer commands, VkImage image, VkImageLayout from, VkImageLayout to,
             VkPipelineStageFlags2 from_stage, VkAccessFlags2 from_access, VkPipelineStageFlags2 to_stage,
             VkAccessFlags2 to_access) {
  VkImageMemoryBarrier2 b{};
  b.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
  b.srcStageMask = from_stage;
  b.srcAccessMask = from_access;
  b.dstStageMask = to_stage;
  b.dstAccessMask = to_access;
  b.oldLayout = from;
  b.newLayout = to;
  b.srcQueueFamilyIndex = b.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  b.image = image;
  b.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  VkDependencyInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
  info.imageMemoryBarrierCount = 1;
  info.pImageMemoryBarriers = &b;
  vkCmdPipelineBarrier2(commands, &info);
}

}  // namespace

Swapchain::Swapchain(render::VulkanDevice& device, Window& window) : device_(device) {
  render::require(window.createSurface(device.instance(), &surface_), "glfwCreateWindowSurface");
  VkBool32 presents = VK_FALSE;
  vkGetPhysicalDeviceSurfaceSupportKHR(device.physical(), device.queueFamily(), surface_, &presents);
  if (presents == VK_FALSE)
    throw base::Error(base::ExitStatus::file, std::string("Vulkan: ") + device.properties().deviceName +
                                                  " cannot show pictures in this window");
  format_ = formatOf(device.physical(), surface_);
  VkFenceCreateInfo fence{};
  fence.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
  render::require(vkCreateFence(device.device(), &fence, nullptr, &acquired_), "vkCreateFence");
}

Swapchain::~Swapchain() {
  vkDeviceWaitIdle(device_.device());
  vkDestroyFence(device_.device(), acquired_, nullptr);
  vkDestroySwapchainKHR(device_.device(), chain_, nullptr);
  vkDestroySurfaceKHR(device_.instance(), surface_, nullptr);
}

void Swapchain::create(uint32_t width, uint32_t height) {
  VkSurfaceCapabilitiesKHR can{};
  render::require(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device_.physical(), surface_, &can),
                  "vkGetPhysicalDeviceSurfaceCapabilitiesKHR");
  const bool fixed = can.currentExtent.width != UINT32_MAX;
  extent_ = fixed ? can.currentExtent : VkExtent2D{width, height};
  VkSwapchainCreateInfoKHR info{};
  info.sType = VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR;
  info.surface = surface_;
  info.minImageCount =
      can.maxImageCount > 0 ? std::min(can.minImageCount + 1, can.maxImageCount) : can.minImageCount + 1;
  info.imageFormat = format_.format;
  info.imageColorSpace = format_.colorSpace;
  info.imageExtent = extent_;
  info.imageArrayLayers = 1;
  info.imageUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  info.preTransform = can.currentTransform;
  info.compositeAlpha = VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR;
  info.presentMode = VK_PRESENT_MODE_FIFO_KHR;
  info.clipped = VK_TRUE;
  info.oldSwapchain = chain_;
  VkSwapchainKHR chain = VK_NULL_HANDLE;
  render::require(vkCreateSwapchainKHR(device_.device(), &info, nullptr, &chain), "vkCreateSwapchainKHR");
  vkDestroySwapchainKHR(device_.device(), chain_, nullptr);
  chain_ = chain;
  uint32_t count = 0;
  vkGetSwapchainImagesKHR(device_.device(), chain_, &count, nullptr);
  images_.resize(count);
  vkGetSwapchainImagesKHR(device_.device(), chain_, &count, images_.data());
}

void Swapchain::show(uint32_t width, uint32_t height, const std::function<render::Image&(VkCommandBuffer)>& record) {
  if (width == 0 || height == 0) return;
  if (chain_ == VK_NULL_HANDLE || extent_.width != width || extent_.height != height) create(width, height);
  if (extent_.width == 0 || extent_.height == 0) return;
  uint32_t index = 0;
  const VkResult got = vkAcquireNextImageKHR(device_.device(), chain_, UINT64_MAX, VK_NULL_HANDLE, acquired_, &index);
  if (got == VK_ERROR_OUT_OF_DATE_KHR) return create(width, height);
  if (got != VK_SUBOPTIMAL_KHR) render::require(got, "vkAcquireNextImageKHR");
  render::require(vkWaitForFences(device_.device(), 1, &acquired_, VK_TRUE, UINT64_MAX), "vkWaitForFences");
  render::require(vkResetFences(device_.device(), 1, &acquired_), "vkResetFences");
  device_.execute([&](VkCommandBuffer commands) {
    render::Image& image = record(commands);
    image.use(commands, kShownFrom);
    barrier(commands, images_[index], VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
            VK_PIPELINE_STAGE_2_NONE, VK_ACCESS_2_NONE, VK_PIPELINE_STAGE_2_BLIT_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT);
    VkImageBlit blit{};
    blit.srcSubresource = blit.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    blit.srcOffsets[1] = {static_cast<int32_t>(image.extent().width), static_cast<int32_t>(image.extent().height), 1};
    blit.dstOffsets[1] = {static_cast<int32_t>(extent_.width), static_cast<int32_t>(extent_.height), 1};
    vkCmdBlitImage(commands, image.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, images_[index],
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &blit, VK_FILTER_NEAREST);
    barrier(commands, images_[index], VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR,
            VK_PIPELINE_STAGE_2_BLIT_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_2_NONE, VK_ACCESS_2_NONE);
  });
  VkPresentInfoKHR present{};
  present.sType = VK_STRUCTURE_TYPE_PRESENT_INFO_KHR;
  present.swapchainCount = 1;
  present.pSwapchains = &chain_;
  present.pImageIndices = &index;
  const VkResult shown = vkQueuePresentKHR(device_.queue(), &present);
  if (shown == VK_ERROR_OUT_OF_DATE_KHR || shown == VK_SUBOPTIMAL_KHR) return create(width, height);
  render::require(shown, "vkQueuePresentKHR");
}

}  // namespace welkin::view
