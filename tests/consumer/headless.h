// SPDX-License-Identifier: Apache-2.0
// What both headless games share: a Vulkan device under validation, memory, and errors.
#pragma once

#include <cstdio>
#include <stdexcept>
#include <vulkan/vulkan_raii.hpp>
#include <welkin/welkin_vulkan.hpp>

inline unsigned messages = 0;  // count for the validation layer

constexpr auto kHostMemory = vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent;

inline void require(const welkin::Status& status) {
  if (!status) throw std::runtime_error(status.message);
}

inline void require(WelkinResult result) {
  if (result != WELKIN_OK) throw std::runtime_error(welkin_argument_error());
}
/// Lets std::unique_ptr own an object of Welkin's C interface.
template <auto destroy>
struct Destroy {
  void operator()(auto* object) const { destroy(object); }
};

inline VKAPI_ATTR VkBool32 VKAPI_CALL onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                                const VkDebugUtilsMessengerCallbackDataEXT* data, void*) {
  ++messages;
  std::fprintf(stderr, "vulkan: %s\n", data->pMessage);
  return VK_FALSE;
}
constexpr vk::DebugUtilsMessengerCreateInfoEXT kMessenger(
    {}, vk::DebugUtilsMessageSeverityFlagBitsEXT::eWarning | vk::DebugUtilsMessageSeverityFlagBitsEXT::eError,
    vk::DebugUtilsMessageTypeFlagBitsEXT::eValidation | vk::DebugUtilsMessageTypeFlagBitsEXT::ePerformance, onMessage);

inline vk::raii::Instance createInstance(const vk::raii::Context& context) {
  const auto synchronisation = vk::ValidationFeatureEnableEXT::eSynchronizationValidation;
  const vk::ValidationFeaturesEXT validation(synchronisation, {}, &kMessenger);
  const vk::ApplicationInfo application("game", 1, nullptr, 0, VK_API_VERSION_1_3);
  const char *const layers = "VK_LAYER_KHRONOS_validation", *const extensions = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
  return {context, vk::InstanceCreateInfo({}, &application, layers, extensions, &validation)};
}

inline vk::raii::Device createDevice(const vk::raii::PhysicalDevice& physical) {
  vk::PhysicalDeviceVulkan13Features features;  // only what Welkin needs
  features.dynamicRendering = features.synchronization2 = VK_TRUE;
  const float priority = 1.0F;
  const vk::DeviceQueueCreateInfo queue({}, 0, 1, &priority);
  return {physical, vk::DeviceCreateInfo({}, queue, {}, {}, {}, &features)};
}

inline vk::raii::DeviceMemory allocate(const vk::raii::PhysicalDevice& physical, const vk::raii::Device& device,
                                       const vk::MemoryRequirements& needs, vk::MemoryPropertyFlags flags) {
  const auto types = physical.getMemoryProperties().memoryTypes;
  for (uint32_t i = 0;; ++i)
    if (((needs.memoryTypeBits >> i) & 1U) != 0 && (types.at(i).propertyFlags & flags) == flags)
      return {device, vk::MemoryAllocateInfo(needs.size, i)};
}

/// The part of Welkin's description of a device that both games share.
inline WelkinVulkanCreateInfo createInfo(const vk::raii::Context& context, const vk::raii::Instance& instance,
                                         const vk::raii::PhysicalDevice& physical, const vk::raii::Device& device) {
  WelkinVulkanCreateInfo info{sizeof(info), VK_API_VERSION_1_3, context.getDispatcher()->vkGetInstanceProcAddr};
  info.instance = *instance;
  info.physical_device = *physical;
  info.device = *device;
  return info;
}
