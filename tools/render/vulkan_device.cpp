// SPDX-License-Identifier: Apache-2.0
// Chooses and creates a headless Vulkan device.
#include "render/vulkan_device.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <limits>
#include <vector>

#include "sky/base/error.h"

namespace welkin::render {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";
constexpr VkFormat kTargetFormat = VK_FORMAT_R32G32B32A32_SFLOAT;

VKAPI_ATTR VkBool32 VKAPI_CALL onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                         const VkDebugUtilsMessengerCallbackDataEXT* data, void* count) {
  ++*static_cast<std::atomic<unsigned>*>(count);
  std::fprintf(stderr, "vulkan: %s\n", data->pMessage);
  return VK_FALSE;
}

bool hasValidationLayer() {
  uint32_t count = 0;
  vkEnumerateInstanceLayerProperties(&count, nullptr);
  std::vector<VkLayerProperties> layers(count);
  vkEnumerateInstanceLayerProperties(&count, layers.data());
  return std::any_of(layers.begin(), layers.end(), [](const VkLayerProperties& layer) {
    return std::strcmp(layer.layerName, kValidationLayer) == 0;
  });
}

/// The first queue family that can draw. The number of families if there is none.
uint32_t graphicsFamily(VkPhysicalDevice device, uint32_t& count) {
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
  const auto found = std::find_if(families.begin(), families.end(), [](const VkQueueFamilyProperties& family) {
    return (family.queueFlags & VK_QUEUE_GRAPHICS_BIT) != 0;
  });
  return static_cast<uint32_t>(found - families.begin());
}

/// The reason why a device cannot be used. Empty when it can.
std::string refusal(VkPhysicalDevice device, const VkPhysicalDeviceProperties& properties) {
  if (properties.apiVersion < VK_API_VERSION_1_3)
    return "has Vulkan " + std::to_string(VK_API_VERSION_MAJOR(properties.apiVersion)) + "." +
           std::to_string(VK_API_VERSION_MINOR(properties.apiVersion)) + ", 1.3 is needed";
  VkPhysicalDeviceVulkan13Features features13{};
  features13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
  VkPhysicalDeviceFeatures2 features{};
  features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
  features.pNext = &features13;
  vkGetPhysicalDeviceFeatures2(device, &features);
  if (features.features.dualSrcBlend == VK_FALSE) return "lacks dualSrcBlend";
  if (features13.dynamicRendering == VK_FALSE) return "lacks dynamicRendering";
  if (features13.synchronization2 == VK_FALSE) return "lacks synchronization2";
  VkFormatProperties format;
  vkGetPhysicalDeviceFormatProperties(device, kTargetFormat, &format);
  if ((format.optimalTilingFeatures & VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT) == 0)
    return "cannot draw into 32-bit float images";
  uint32_t families = 0;
  if (graphicsFamily(device, families) == families) return "has no graphics queue";
  return {};
}

/// Rank of a device type. Lower is better.
int rankOf(VkPhysicalDeviceType type) {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
      return 0;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
      return 1;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
      return 2;
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
      return 3;
    default:
      return 4;
  }
}

}  // namespace

void require(VkResult result, const char* call) {
  if (result != VK_SUCCESS)
    throw base::Error(base::ExitStatus::file,
                      std::string("Vulkan: ") + call + " failed: VkResult " + std::to_string(result));
}

VulkanDevice::VulkanDevice(bool validate, const WindowNeeds& window) {
  try {
    createInstance(validate, window.extensions);
    chooseDevice(window);
    createDevice(!window.extensions.empty());
  } catch (...) {
    destroy();
    throw;
  }
}

VulkanDevice::~VulkanDevice() {
  destroy();
}

void VulkanDevice::destroy() {
  if (device_ != VK_NULL_HANDLE) {
    vkDestroyCommandPool(device_, pool_, nullptr);
    vkDestroyDevice(device_, nullptr);
  }
  if (messenger_ != VK_NULL_HANDLE) vkDestroyDebugUtilsMessengerEXT(instance_, messenger_, nullptr);
  if (instance_ != VK_NULL_HANDLE) vkDestroyInstance(instance_, nullptr);
}

void VulkanDevice::createInstance(bool validate, std::span<const char* const> extensions) {
  if (volkInitialize() != VK_SUCCESS)
    throw base::Error(base::ExitStatus::file,
                      "Vulkan: no loader found (libvulkan.so.1); install a Vulkan loader and driver");
  if (volkGetInstanceVersion() < VK_API_VERSION_1_3)
    throw base::Error(base::ExitStatus::file, "Vulkan: the loader is older than 1.3");
  if (validate && !hasValidationLayer())
    throw base::Error(base::ExitStatus::file, std::string("Vulkan: validation was asked for, but the layer ") +
                                                  kValidationLayer + " is not installed");

  const VkValidationFeatureEnableEXT enabled = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
  VkValidationFeaturesEXT validation{};
  validation.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT;
  validation.enabledValidationFeatureCount = 1;
  validation.pEnabledValidationFeatures = &enabled;
  VkDebugUtilsMessengerCreateInfoEXT messenger{};
  messenger.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
  messenger.pNext = &validation;
  messenger.messageSeverity =
      VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  messenger.messageType =
      VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
  messenger.pfnUserCallback = onMessage;
  messenger.pUserData = &message_count_;

  VkApplicationInfo application{};
  application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
  application.pApplicationName = "welkin";
  application.apiVersion = VK_API_VERSION_1_3;
  std::vector<const char*> enabled_extensions(extensions.begin(), extensions.end());
  if (validate) enabled_extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
  VkInstanceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
  info.pApplicationInfo = &application;
  info.enabledExtensionCount = static_cast<uint32_t>(enabled_extensions.size());
  info.ppEnabledExtensionNames = enabled_extensions.data();
  if (validate) {
    info.pNext = &messenger;
    info.enabledLayerCount = 1;
    info.ppEnabledLayerNames = &kValidationLayer;
  }
  const VkResult result = vkCreateInstance(&info, nullptr, &instance_);
  if (result == VK_ERROR_INCOMPATIBLE_DRIVER)
    throw base::Error(base::ExitStatus::file, "Vulkan: no driver found; install one (Mesa's lavapipe needs no GPU)");
  require(result, "vkCreateInstance");
  volkLoadInstance(instance_);
  if (!validate) return;
  messenger.pNext = nullptr;
  require(vkCreateDebugUtilsMessengerEXT(instance_, &messenger, nullptr, &messenger_),
          "vkCreateDebugUtilsMessengerEXT");
}

void VulkanDevice::chooseDevice(const WindowNeeds& window) {
  uint32_t count = 0;
  require(vkEnumeratePhysicalDevices(instance_, &count, nullptr), "vkEnumeratePhysicalDevices");
  std::vector<VkPhysicalDevice> devices(count);
  require(vkEnumeratePhysicalDevices(instance_, &count, devices.data()), "vkEnumeratePhysicalDevices");
  std::string reasons;
  int best = std::numeric_limits<int>::max();
  for (VkPhysicalDevice device : devices) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(device, &properties);
    std::string why = refusal(device, properties);
    uint32_t families = 0;
    if (why.empty() && window.presents && !window.presents(instance_, device, graphicsFamily(device, families)))
      why = "cannot show pictures in this window";
    if (!why.empty()) {
      reasons += std::string("\n  ") + properties.deviceName + " " + why;
    } else if (rankOf(properties.deviceType) < best) {
      best = rankOf(properties.deviceType);
      physical_ = device;
      properties_ = properties;
    }
  }
  if (physical_ == VK_NULL_HANDLE)
    throw base::Error(base::ExitStatus::file,
                      "Vulkan: no device can be used" + (reasons.empty() ? ": there is none" : reasons));
}

void VulkanDevice::createDevice(bool presents) {
  uint32_t families = 0;
  queue_family_ = graphicsFamily(physical_, families);
  const float priority = 1.0F;
  VkDeviceQueueCreateInfo queue{};
  queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
  queue.queueFamilyIndex = queue_family_;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  VkPhysicalDeviceVulkan13Features features{};
  features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
  features.dynamicRendering = VK_TRUE;
  features.synchronization2 = VK_TRUE;
  VkPhysicalDeviceFeatures blending{};
  blending.dualSrcBlend = VK_TRUE;
  VkDeviceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
  info.pNext = &features;
  info.pEnabledFeatures = &blending;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  const char* const swapchain = VK_KHR_SWAPCHAIN_EXTENSION_NAME;
  info.enabledExtensionCount = presents ? 1 : 0;
  info.ppEnabledExtensionNames = &swapchain;
  require(vkCreateDevice(physical_, &info, nullptr, &device_), "vkCreateDevice");
  vkGetDeviceQueue(device_, queue_family_, 0, &queue_);
  VkCommandPoolCreateInfo pool{};
  pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
  pool.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
  pool.queueFamilyIndex = queue_family_;
  require(vkCreateCommandPool(device_, &pool, nullptr, &pool_), "vkCreateCommandPool");
}

uint32_t VulkanDevice::memoryType(uint32_t allowed, VkMemoryPropertyFlags needed) const {
  VkPhysicalDeviceMemoryProperties memory;
  vkGetPhysicalDeviceMemoryProperties(physical_, &memory);
  for (uint32_t i = 0; i < memory.memoryTypeCount; ++i)
    if ((allowed & (1U << i)) != 0 && (memory.memoryTypes[i].propertyFlags & needed) == needed) return i;
  throw base::Error(base::ExitStatus::file,
                    std::string("Vulkan: ") + properties_.deviceName + " has no memory of the needed kind");
}

void VulkanDevice::execute(const std::function<void(VkCommandBuffer)>& record) {
  VkCommandBufferAllocateInfo allocate{};
  allocate.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
  allocate.commandPool = pool_;
  allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  allocate.commandBufferCount = 1;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  require(vkAllocateCommandBuffers(device_, &allocate, &commands), "vkAllocateCommandBuffers");
  VkCommandBufferBeginInfo begin{};
  begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  require(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
  record(commands);
  require(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
  VkCommandBufferSubmitInfo buffer{};
  buffer.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO;
  buffer.commandBuffer = commands;
  VkSubmitInfo2 submit{};
  submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2;
  submit.commandBufferInfoCount = 1;
  submit.pCommandBufferInfos = &buffer;
  require(vkQueueSubmit2(queue_, 1, &submit, VK_NULL_HANDLE), "vkQueueSubmit2");
  require(vkQueueWaitIdle(queue_), "vkQueueWaitIdle");
  vkFreeCommandBuffers(device_, pool_, 1, &commands);
}

}  // namespace welkin::render
