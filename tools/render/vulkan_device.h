// SPDX-License-Identifier: Apache-2.0
// A headless Vulkan 1.3 device: a real GPU if there is one, otherwise a software rasteriser (lavapipe).
#pragma once

#include <volk.h>

#include <atomic>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace welkin::render {

/// Throws Error(file), naming the call, when `result` is not success.
void require(VkResult result, const char* call);

/// What a device needs to show pictures in a window.
struct WindowNeeds {
  std::vector<const char*> extensions;  ///< of the instance, for the window's surface; empty: no window
  /// Whether a queue family of a device can show pictures in the window.
  std::function<bool(VkInstance, VkPhysicalDevice, uint32_t family)> presents;
};

/// Instance, device, one graphics queue and one command pool. It uses volk's global function pointers, so only one may
/// exist at a time.
class VulkanDevice {
 public:
  /// `validate` enables Khronos' validation layer with core and synchronisation checks. Its messages go to stderr and
  /// are counted. Throws Error(file) when there is no loader, driver, layer or device; the message says why each was
  /// refused.
  /// `window`: only a device that can show pictures in it is chosen.
  explicit VulkanDevice(bool validate, const WindowNeeds& window = {});
  ~VulkanDevice();
  VulkanDevice(const VulkanDevice&) = delete;
  VulkanDevice& operator=(const VulkanDevice&) = delete;

  VkInstance instance() const { return instance_; }
  VkPhysicalDevice physical() const { return physical_; }
  VkDevice device() const { return device_; }
  VkQueue queue() const { return queue_; }
  uint32_t queueFamily() const { return queue_family_; }
  const VkPhysicalDeviceProperties& properties() const { return properties_; }

  /// Number of validation messages so far of severity warning or error. 0 without validation.
  unsigned messageCount() const { return message_count_; }

  /// Index of a memory type in `allowed` that has all of `needed`.
  uint32_t memoryType(uint32_t allowed, VkMemoryPropertyFlags needed) const;

  /// Records, submits and waits.
  void execute(const std::function<void(VkCommandBuffer)>& record);

 private:
  void createInstance(bool validate, std::span<const char* const> extensions);
  void chooseDevice(const WindowNeeds& window);
  void createDevice(bool presents);
  void destroy();

  std::atomic<unsigned> message_count_ = 0;
  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  VkPhysicalDeviceProperties properties_{};
  uint32_t queue_family_ = 0;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  VkCommandPool pool_ = VK_NULL_HANDLE;
};

}  // namespace welkin::render
