// SPDX-License-Identifier: Apache-2.0
#include "render/level_lamps.h"

#include <algorithm>

namespace welkin::render {
namespace {

void set(float (&to)[4], const f64::Number3& v, double w) {
  for (int i = 0; i < 3; ++i) to[i] = static_cast<float>(v[i]);
  to[3] = static_cast<float>(w);
}

}  // namespace

LevelLamps::LevelLamps(const VulkanDevice& device, const level::Scene& scene, double luminance_unit)
    : buffer_(device, std::max<std::size_t>(scene.lights.size(), 1) * sizeof(LevelLamp),
              VK_BUFFER_USAGE_STORAGE_BUFFER_BIT) {
  LevelLamp* lamp = buffer_.as<LevelLamp>();
  for (const geometry::StaticLight& light : scene.lights) {
    set(lamp->position, light.position, light.inverse_range4);
    set(lamp->axis, light.axis, light.directional ? 1.0 : 0.0);
    set(lamp->intensity, light.intensity / luminance_unit, 0.0);
    set(lamp->cone, {light.cone_scale, light.cone_offset, 0.0}, 0.0);
    ++lamp;
  }
}

}  // namespace welkin::render
