// SPDX-License-Identifier: Apache-2.0
// Draws the dome and the spheres with the runtime's Vulkan passes.
#include "render/views.h"

#include <algorithm>
#include <cmath>

#include "sky/base/error.h"

namespace welkin::render {
Views::Views(VulkanDevice& device, const Sky& sky, WelkinVulkanSource source)
    : device_(device),
      source_(source),
      runtime_(device, sky),
      spheres_(device, runtime_.layout(), Offscreen::kFormat, sky.info().mode_count > 0) {}

FloatImage Views::drawDome(uint32_t width, uint32_t height, const WelkinVulkanView& view) {
  Offscreen target(device_, width, height);
  return target.render([&](VkCommandBuffer commands) { runtime_.recordDome(commands, view); });
}

FloatImage Views::dome(uint32_t width, uint32_t height, bool discs) {
  WelkinVulkanView view{};
  view.source = source_;
  view.projection = WELKIN_VULKAN_FISHEYE;
  view.aspect = static_cast<float>(width) / static_cast<float>(height);
  view.discs = discs ? 1 : 0;
  return drawDome(width, height, view);
}

FloatImage Views::perspective(uint32_t width, uint32_t height, const Camera& camera, bool discs) {
  WelkinVulkanView view{};
  view.source = source_;
  view.projection = WELKIN_VULKAN_PERSPECTIVE;
  const auto matrix = inverseViewProjection(camera, static_cast<double>(width) / height);
  std::copy(matrix.begin(), matrix.end(), view.inverse_view_projection);
  view.discs = discs ? 1 : 0;
  return drawDome(width, height, view);
}

FloatImage Views::spheres(uint32_t width, uint32_t height, const Camera& camera, SkyLight light) {
  render::shaders::SpheresPush push{};
  const auto matrix = inverseViewProjection(camera, static_cast<double>(width) / height);
  std::copy(matrix.begin(), matrix.end(), push.inverse_view_projection);
  push.aspect = static_cast<float>(width) / static_cast<float>(height);
  push.light = static_cast<uint32_t>(light);
  push.from_cubemaps = source_ == WELKIN_VULKAN_CUBEMAP ? 1 : 0;
  Offscreen target(device_, width, height);
  return target.render([&](VkCommandBuffer commands) { spheres_.record(commands, runtime_.set(), push); });
}

Camera towardsLight(const WelkinSkySample& sample) {
  constexpr float kNauticalTwilight = -0.2079F;  // sin of -12 degrees
  const bool moon_only = sample.sun.direction[1] < kNauticalTwilight && sample.moon.direction[1] > 0.0F;
  const float* d = moon_only ? sample.moon.direction : sample.sun.direction;
  return {std::atan2(static_cast<double>(d[0]), -static_cast<double>(d[2])), 0.0, 1.0};
}

}  // namespace welkin::render
