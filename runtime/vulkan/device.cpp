// SPDX-License-Identifier: Apache-2.0
// Loads Vulkan functions through the caller's vkGetInstanceProcAddr and checks the device's features.
#include "vulkan/device.h"

namespace welkin::vulkan {

WelkinResult check(VkResult result, const char* what, WelkinMessage* message) {
  if (result == VK_SUCCESS) return WELKIN_OK;
  const bool memory = result == VK_ERROR_OUT_OF_HOST_MEMORY || result == VK_ERROR_OUT_OF_DEVICE_MEMORY ||
                      result == VK_ERROR_OUT_OF_POOL_MEMORY || result == VK_ERROR_FRAGMENTED_POOL;
  return fail(message, memory ? WELKIN_ERROR_MEMORY : WELKIN_ERROR_DEVICE, "%s: VkResult %d", what,
              static_cast<int>(result));
}

void Device::nameObject(VkObjectType type, uint64_t object, const char* text) const {
  if (fn.SetDebugUtilsObjectNameEXT == nullptr || object == 0) return;
  VkDebugUtilsObjectNameInfoEXT info{};
  info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT;
  info.objectType = type;
  info.objectHandle = object;
  info.pObjectName = text;
  fn.SetDebugUtilsObjectNameEXT(handle, &info);  // failing to set a name is no error
}

namespace {

WelkinResult loadFunctions(const WelkinVulkanCreateInfo& info, Functions& fn, WelkinMessage* message) {
#define WELKIN_LOAD_INSTANCE(name)                                                                  \
  fn.name = reinterpret_cast<PFN_vk##name>(info.get_instance_proc_addr(info.instance, "vk" #name)); \
  if (fn.name == nullptr) return fail(message, WELKIN_ERROR_DEVICE, "the instance has no vk%s", #name);
  WELKIN_VULKAN_INSTANCE_FUNCTIONS(WELKIN_LOAD_INSTANCE)
#undef WELKIN_LOAD_INSTANCE
#define WELKIN_LOAD_DEVICE(name)                                                           \
  fn.name = reinterpret_cast<PFN_vk##name>(fn.GetDeviceProcAddr(info.device, "vk" #name)); \
  if (fn.name == nullptr) return fail(message, WELKIN_ERROR_DEVICE, "the device has no vk%s", #name);
  WELKIN_VULKAN_DEVICE_FUNCTIONS(WELKIN_LOAD_DEVICE)
#undef WELKIN_LOAD_DEVICE
  fn.SetDebugUtilsObjectNameEXT = reinterpret_cast<PFN_vkSetDebugUtilsObjectNameEXT>(
      info.get_instance_proc_addr(info.instance, "vkSetDebugUtilsObjectNameEXT"));
  return WELKIN_OK;
}

}  // namespace

WelkinResult checkFormat(const Device& device, VkFormat format, VkFormatFeatureFlags needed, const char* what,
                         WelkinMessage* message) {
  VkFormatProperties properties;
  device.fn.GetPhysicalDeviceFormatProperties(device.physical, format, &properties);
  if ((properties.optimalTilingFeatures & needed) == needed) return WELKIN_OK;
  return fail(message, WELKIN_ERROR_DEVICE, "%s: VkFormat %d lacks the features %#x (it has %#x)", what,
              static_cast<int>(format), needed, properties.optimalTilingFeatures);
}

WelkinResult openDevice(const WelkinVulkanCreateInfo& info, Device& device, WelkinMessage* message) {
  if (info.get_instance_proc_addr == nullptr || info.instance == nullptr || info.physical_device == nullptr ||
      info.device == nullptr)
    return fail(message, WELKIN_ERROR_ARGUMENT,
                "get_instance_proc_addr, instance, physical_device and device must be given");
  if (info.api_version < VK_API_VERSION_1_3)
    return fail(message, WELKIN_ERROR_DEVICE, "api_version is %u.%u; Vulkan 1.3 is needed",
                VK_API_VERSION_MAJOR(info.api_version), VK_API_VERSION_MINOR(info.api_version));
  device.physical = info.physical_device;
  device.handle = info.device;
  device.allocator = info.allocator;
  if (info.memory != nullptr) {
    if (const auto result = core::sized("welkin_vulkan_create", "info->memory", info.memory))
      return fail(message, result, "%s", welkin_argument_error());
    if (info.memory->allocate == nullptr || info.memory->free == nullptr)
      return fail(message, WELKIN_ERROR_ARGUMENT, "memory must give both allocate and free");
    device.callbacks = core::take(*info.memory);
  }
  if (const auto result = loadFunctions(info, device.fn, message)) return result;
  device.fn.GetPhysicalDeviceProperties(device.physical, &device.properties);
  device.fn.GetPhysicalDeviceMemoryProperties(device.physical, &device.memory);
  if (device.properties.apiVersion < VK_API_VERSION_1_3)
    return fail(message, WELKIN_ERROR_DEVICE, "%.100s has Vulkan %u.%u; 1.3 is needed", device.properties.deviceName,
                VK_API_VERSION_MAJOR(device.properties.apiVersion), VK_API_VERSION_MINOR(device.properties.apiVersion));
  constexpr VkFormatFeatureFlags kFetch = VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT | VK_FORMAT_FEATURE_TRANSFER_DST_BIT;
  constexpr VkFormatFeatureFlags kFilter = kFetch | VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT |
                                           VK_FORMAT_FEATURE_BLIT_SRC_BIT | VK_FORMAT_FEATURE_BLIT_DST_BIT;
  if (const auto result = checkFormat(device, VK_FORMAT_R32G32B32A32_SFLOAT, kFetch, "gradients", message))
    return result;
  if (const auto result = checkFormat(device, VK_FORMAT_R16G16B16A16_SFLOAT, kFilter, "cubemaps", message))
    return result;
  if (const auto result =
          checkFormat(device, info.colour_format, VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT, "colour_format", message))
    return result;
  if (info.depth_format == VK_FORMAT_UNDEFINED) return WELKIN_OK;
  return checkFormat(device, info.depth_format, VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT, "depth_format",
                     message);
}

}  // namespace welkin::vulkan
