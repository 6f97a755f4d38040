// SPDX-License-Identifier: Apache-2.0
// The object of welkin_vulkan.h: all that it holds on the caller's device.
#pragma once

#include <memory>

#include "core/constants.h"
#include "vulkan/descriptors.h"
#include "vulkan/dome_pipeline.h"
#include "vulkan/memory.h"

namespace welkin::vulkan {

struct Frame {
  uint32_t cubemap[2] = {};  ///< indices of the cubemaps in its descriptor set
  bool updated = false;
};

}  // namespace welkin::vulkan

struct WelkinVulkanSky {
  welkin::vulkan::Device device;
  welkin::core::SkyShape shape;
  welkin::vulkan::Descriptors descriptors;
  welkin::vulkan::DomePipeline dome;
  std::unique_ptr<welkin::vulkan::Image[]> images;  ///< gradients, stars, modes, cubemaps; black if missing
  uint32_t image_count = 0;
  uint32_t cubemap_count = 0;  ///< cubemaps in the file
  WelkinVulkanAllocation image_memory{};
  VkDeviceSize image_bytes = 0;
  welkin::vulkan::MappedBuffer staging;
  welkin::vulkan::MappedBuffer uniforms;
  VkDeviceSize slice_bytes = 0;  ///< distance between the constants of two frames
  uint32_t frame_count = 0;
  welkin::vulkan::Frame frames[WELKIN_VULKAN_MAX_FRAMES_IN_FLIGHT];
  bool upload_recorded = false;
};
