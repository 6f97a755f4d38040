// SPDX-License-Identifier: Apache-2.0
// The probes of a baked level as the volume of the runtime, around the camera of each picture.
#pragma once

#include <welkin/welkin_vulkan_volume.h>

#include <memory>
#include <optional>

#include "render/vulkan_device.h"
#include "shared.h"

namespace welkin::render {

/// The game's factors on the light of probes.
struct ProbeParts {
  float sky = 1.0F, sun_bounce = 1.0F, local = 1.0F;
};

class LevelVolume {
 public:
  /// `device` and `level`, with its sectors resident, must outlive the object.
  LevelVolume(VulkanDevice& device, WelkinLevel& level, const ProbeParts& parts);

  void setParts(const ProbeParts& parts) { parts_ = parts; }

  /// The level has had another light meanwhile: the next update() relights it.
  void forgetLight() { lit_.reset(); }

  /// Relights all probes, if the light is not that of the last call, and centres the volume on a position. Throws
  /// Error.
  void update(const WelkinSkySample& sample, const f64::Number3& position);

  VkDescriptorSetLayout layout() const { return welkin_vulkan_volume_descriptor_set_layout(textures_.get()); }
  VkDescriptorSet set() const { return welkin_vulkan_volume_descriptor_set(textures_.get(), 0); }

 private:
  struct Destroy {
    void operator()(WelkinVolume* volume) const { welkin_volume_destroy(volume); }
    void operator()(WelkinVulkanVolume* volume) const { welkin_vulkan_volume_destroy(volume); }
  };

  VulkanDevice& device_;
  WelkinLevel& level_;
  ProbeParts parts_;
  struct Lit {
    WelkinSkySample sample;
    ProbeParts parts;
  };
  std::optional<Lit> lit_;  ///< what the level was last lit by, here
  std::unique_ptr<WelkinVolume, Destroy> volume_;
  std::unique_ptr<WelkinVulkanVolume, Destroy> textures_;
};

}  // namespace welkin::render
