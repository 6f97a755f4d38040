// SPDX-License-Identifier: Apache-2.0
// The pictures of a window.
#pragma once

#include <functional>
#include <vector>

#include "render/image.h"
#include "view/window_module.h"

namespace welkin::view {

class Swapchain {
 public:
  /// Throws Error(file) if the device cannot show pictures in the window.
  Swapchain(render::VulkanDevice& device, Window& window);
  ~Swapchain();
  Swapchain(const Swapchain&) = delete;
  Swapchain& operator=(const Swapchain&) = delete;

  /// Shows an image, encoded in 8 bits, that `record` draws and returns. Waits. Nothing is shown while the window is
  /// minimised or changes its size; then the next call does.
  void show(uint32_t width, uint32_t height, const std::function<render::Image&(VkCommandBuffer)>& record);

 private:
  void create(uint32_t width, uint32_t height);

  render::VulkanDevice& device_;
  VkSurfaceKHR surface_ = VK_NULL_HANDLE;
  VkSurfaceFormatKHR format_{};
  VkSwapchainKHR chain_ = VK_NULL_HANDLE;
  VkFence acquired_ = VK_NULL_HANDLE;
  VkExtent2D extent_{};
  std::vector<VkImage> images_;
};

}  // namespace welkin::view
