// SPDX-License-Identifier: Apache-2.0
// The caller's device, the Vulkan functions used on it, and reports of errors.
#pragma once

#include <welkin/welkin_vulkan.h>

#include "core/arguments.h"

namespace welkin {

template <>
inline constexpr std::size_t core::kFirstSize<WelkinVulkanMemoryCallbacks> = 32;
template <>
inline constexpr std::size_t core::kFirstSize<WelkinVulkanCreateInfo> = 104;
template <>
inline constexpr std::size_t core::kFirstSize<WelkinVulkanView> = 92;
template <>
inline constexpr std::size_t core::kFirstSize<WelkinVulkanMemory> = 32;

}  // namespace welkin

namespace welkin::vulkan {

#define WELKIN_VULKAN_INSTANCE_FUNCTIONS(X) \
  X(GetPhysicalDeviceMemoryProperties)      \
  X(GetPhysicalDeviceProperties)            \
  X(GetPhysicalDeviceFormatProperties)      \
  X(GetDeviceProcAddr)

#define WELKIN_VULKAN_DEVICE_FUNCTIONS(X) \
  X(AllocateDescriptorSets)               \
  X(AllocateMemory)                       \
  X(BindBufferMemory)                     \
  X(BindImageMemory)                      \
  X(CmdBindDescriptorSets)                \
  X(CmdBindPipeline)                      \
  X(CmdBlitImage)                         \
  X(CmdCopyBuffer)                        \
  X(CmdCopyBufferToImage)                 \
  X(CmdDispatch)                          \
  X(CmdDraw)                              \
  X(CmdPipelineBarrier2)                  \
  X(CmdPushConstants)                     \
  X(CmdSetBlendConstants)                 \
  X(CreateBuffer)                         \
  X(CreateComputePipelines)               \
  X(CreateDescriptorPool)                 \
  X(CreateDescriptorSetLayout)            \
  X(CreateGraphicsPipelines)              \
  X(CreateImage)                          \
  X(CreateImageView)                      \
  X(CreatePipelineLayout)                 \
  X(CreateSampler)                        \
  X(CreateShaderModule)                   \
  X(DestroyBuffer)                        \
  X(DestroyDescriptorPool)                \
  X(DestroyDescriptorSetLayout)           \
  X(DestroyImage)                         \
  X(DestroyImageView)                     \
  X(DestroyPipeline)                      \
  X(DestroyPipelineLayout)                \
  X(DestroySampler)                       \
  X(DestroyShaderModule)                  \
  X(FreeMemory)                           \
  X(GetBufferMemoryRequirements)          \
  X(GetImageMemoryRequirements)           \
  X(MapMemory)                            \
  X(UpdateDescriptorSets)

/// The functions, without their vk prefix.
struct Functions {
#define WELKIN_DECLARE(name) PFN_vk##name name = nullptr;
  WELKIN_VULKAN_INSTANCE_FUNCTIONS(WELKIN_DECLARE)
  WELKIN_VULKAN_DEVICE_FUNCTIONS(WELKIN_DECLARE)
#undef WELKIN_DECLARE
  PFN_vkSetDebugUtilsObjectNameEXT SetDebugUtilsObjectNameEXT = nullptr;  ///< null without VK_EXT_debug_utils
};

struct Device {
  Functions fn;
  VkPhysicalDevice physical = VK_NULL_HANDLE;
  VkDevice handle = VK_NULL_HANDLE;
  const VkAllocationCallbacks* allocator = nullptr;
  VkPhysicalDeviceProperties properties{};
  VkPhysicalDeviceMemoryProperties memory{};
  WelkinVulkanMemoryCallbacks callbacks{};  ///< if `allocate` is null, the library allocates

  /// Names an object for debuggers and validation messages.
  template <typename Handle>
  void name(VkObjectType type, Handle object, const char* text) const {
    nameObject(type, reinterpret_cast<uint64_t>(object), text);
  }

 private:
  void nameObject(VkObjectType type, uint64_t object, const char* text) const;
};

using core::fail;

/// WELKIN_OK if `result` is a success. Else WELKIN_ERROR_MEMORY or WELKIN_ERROR_DEVICE, and the message
/// "`what`: `result`".
WelkinResult check(VkResult result, const char* what, WelkinMessage* message);

/// WELKIN_OK if optimally tiled images of `format` have the features. Else WELKIN_ERROR_DEVICE; its message names
/// `what`.
WelkinResult checkFormat(const Device& device, VkFormat format, VkFormatFeatureFlags needed, const char* what,
                         WelkinMessage* message);

/// Loads the functions and checks version, formats and limits.
WelkinResult openDevice(const WelkinVulkanCreateInfo& info, Device& device, WelkinMessage* message);

}  // namespace welkin::vulkan
