// SPDX-License-Identifier: Apache-2.0
// The runtime's Vulkan object of a sky, created and uploaded, and its sample at an hour.
#pragma once

#include <welkin/welkin_vulkan.h>

#include <memory>
#include <welkin/welkin.hpp>

#include "render/vulkan_device.h"

namespace welkin::render {

/// Throws Error(internal) if `result`, of a runtime call that should never fail, is an error.
void require(WelkinResult result, const char* call);

/// The create info for a sky drawn into Offscreen's format, without a depth attachment.
WelkinVulkanCreateInfo createInfo(const VulkanDevice& device, uint32_t frames_in_flight);

class RuntimeSky {
 public:
  /// Draws a dome into Offscreen's format, without a depth attachment unless `depth_format` is given. `sky` and
  /// `device` must outlive the object.
  RuntimeSky(VulkanDevice& device, const Sky& sky, VkFormat depth_format = VK_FORMAT_UNDEFINED,
             VkCompareOp depth_compare = VK_COMPARE_OP_ALWAYS);

  /// Sets the hour. Throws Error(usage) when it is not finite. `tint` = false removes the polarising tint from the dome
  /// drawn from the formulas. Cubemaps keep it, because it was baked into them.
  void setTime(double time_h, bool tint = true);

  /// Sets a sample of this sky, or a changed one.
  void setSample(const WelkinSkySample& sample);

  const WelkinSkySample& sample() const { return sample_; }
  const WelkinVulkanSky* get() const { return runtime_.get(); }
  VkDescriptorSetLayout layout() const { return welkin_vulkan_descriptor_set_layout(runtime_.get()); }
  VkDescriptorSet set() const { return welkin_vulkan_descriptor_set(runtime_.get(), 0); }

  void recordDome(VkCommandBuffer commands, const WelkinVulkanView& view) const;

 private:
  struct Destroy {
    void operator()(WelkinVulkanSky* object) const { welkin_vulkan_destroy(object); }
  };

  const Sky& sky_;
  std::unique_ptr<WelkinVulkanSky, Destroy> runtime_;
  WelkinSkySample sample_{};
};

}  // namespace welkin::render
