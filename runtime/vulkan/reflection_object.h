// SPDX-License-Identifier: Apache-2.0
// The object of welkin_vulkan_reflection.h: a cubemap of the filtered sky, and the pass that fills it.
#pragma once

#include <welkin/sky_constants.h>
#include <welkin/welkin_vulkan_reflection.h>

#include <array>
#include <cstddef>

#include "vulkan/frame_sets.h"
#include "vulkan/memory.h"

namespace welkin::vulkan {

inline constexpr uint32_t kReflectionLastEdge = 4;  ///< texels along an edge of the last mip
inline constexpr uint32_t kMostReflectionMips = 8;  ///< of WELKIN_REFLECTION_MOST_SIZE

/// The part of the sky's constants that the dome depends on: all before the discs.
inline constexpr size_t kDomeBytes = offsetof(WelkinSkyConstants, sun_disc);

}  // namespace welkin::vulkan

struct WelkinVulkanReflection {
  welkin::vulkan::Device device;
  uint32_t size = 0;
  uint32_t mips = 0;
  VkImage image = VK_NULL_HANDLE;
  VkImageView cube = VK_NULL_HANDLE;  ///< of all mips
  VkImageView mip_views[welkin::vulkan::kMostReflectionMips] = {};
  WelkinVulkanAllocation memory{};
  VkDeviceSize bytes = 0;
  VkSampler sampler = VK_NULL_HANDLE;
  welkin::vulkan::FrameSets read;     ///< one set, for the game
  welkin::vulkan::FrameSets written;  ///< a set for each mip
  VkPipelineLayout pipeline_layout = VK_NULL_HANDLE;
  VkPipeline pipeline = VK_NULL_HANDLE;
  const WelkinVulkanSky* sky = nullptr;                      ///< of the last call
  std::array<std::byte, welkin::vulkan::kDomeBytes> dome{};  ///< likewise
  uint32_t next = 0;                                         ///< the piece that is filtered next
  uint32_t left = 0;                                         ///< pieces that do not show that dome
  bool is_filled = false;

  uint32_t pieces() const { return 6 * mips; }
};

namespace welkin::vulkan {

/// Creates image, views, sets and pipeline. `o` has the device, size and mips; `sky` is the layout of the sky's set.
WelkinResult createReflection(WelkinVulkanReflection& o, VkDescriptorSetLayout sky, VkPipelineCache cache,
                              WelkinMessage* message);
void destroy(WelkinVulkanReflection& o);

}  // namespace welkin::vulkan
