// SPDX-License-Identifier: Apache-2.0
// The runtime's filtered sky, for the gloss of a level's materials.
#pragma once

#include <welkin/welkin_vulkan_reflection.h>

#include <memory>

#include "render/runtime_sky.h"

namespace welkin::render {

class LevelReflection {
 public:
  static constexpr uint32_t kSize = 128;  ///< texels along an edge of the first mip

  /// `device` and `sky` must outlive the object.
  LevelReflection(const VulkanDevice& device, const RuntimeSky& sky);

  /// Records the passes that show the sky's present dome, where they do not yet; outside of rendering.
  void record(VkCommandBuffer commands);

  VkDescriptorSetLayout layout() const { return welkin_vulkan_reflection_descriptor_set_layout(chain_.get()); }
  VkDescriptorSet set() const { return welkin_vulkan_reflection_descriptor_set(chain_.get()); }

 private:
  struct Destroy {
    void operator()(WelkinVulkanReflection* object) const { welkin_vulkan_reflection_destroy(object); }
  };

  const RuntimeSky& sky_;
  std::unique_ptr<WelkinVulkanReflection, Destroy> chain_;
};

}  // namespace welkin::render
