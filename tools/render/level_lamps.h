// SPDX-License-Identifier: Apache-2.0
// A scene's own lights on the device.
#pragma once

#include "probes/level/scene.h"
#include "render/buffer.h"

namespace welkin::render {

/// A light as level_lamps.glsl reads it.
struct LevelLamp {
  float position[4];
  float axis[4];
  float intensity[4];
  float cone[4];
};

class LevelLamps {
 public:
  /// Scene units: the files' candela and lux over `luminance_unit`, cd/m2.
  LevelLamps(const VulkanDevice& device, const level::Scene& scene, double luminance_unit);

  VkBuffer handle() const { return buffer_.handle(); }

 private:
  Buffer buffer_;  ///< never empty
};

}  // namespace welkin::render
