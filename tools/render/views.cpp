// SPDX-License-Identifier: Apache-2.0
// Draws the dome and the spheres with the runtime's Vulkan passes.
#include "render/views.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sky/error.h"

namespace welkin::tools {
namespace {

void require(WelkinResult result, const char* call) {
  if (result != WELKIN_OK)
    throw Error(ExitStatus::internal, std::string(call) + " failed: " + welkin_result_string(result));
}

WelkinVulkanCreateInfo createInfo(const VulkanDevice& device) {
  WelkinVulkanCreateInfo info{};
  info.struct_size = sizeof(info);
  info.api_version = VK_API_VERSION_1_3;
  info.get_instance_proc_addr = vkGetInstanceProcAddr;
  info.instance = device.instance();
  info.physical_device = device.physical();
  info.device = device.device();
  info.frames_in_flight = 1;
  info.colour_format = Offscreen::kFormat;
  return info;
}

}  // namespace

Views::Views(VulkanDevice& device, const Sky& sky, WelkinVulkanSource source)
    : device_(device), sky_(sky), source_(source) {
  if (source == WELKIN_VULKAN_CUBEMAP && sky.info().cubemap_count == 0)
    throw Error(ExitStatus::content,
                "the sky has no cubemaps; draw it with the analytic sky, or bake with cubemap_size");
  const WelkinVulkanCreateInfo info = createInfo(device);
  WelkinVulkanSky* runtime = nullptr;
  WelkinMessage message{};
  if (welkin_vulkan_create(&info, sky.get(), &runtime, &message) != WELKIN_OK)
    throw Error(ExitStatus::file, std::string("Vulkan: ") + message.text);
  runtime_.reset(runtime);
  device_.execute(
      [&](VkCommandBuffer commands) { require(welkin_vulkan_record_upload(runtime, commands), "record_upload"); });
  welkin_vulkan_free_staging(runtime);
  spheres_ = std::make_unique<SpherePipeline>(device, welkin_vulkan_descriptor_set_layout(runtime), Offscreen::kFormat);
}

void Views::setTime(double time_h) {
  if (!sky_.sample(time_h, sample_)) throw Error(ExitStatus::usage, "the time must be a finite number of hours");
  require(welkin_vulkan_update(runtime_.get(), 0, &sample_), "welkin_vulkan_update");
}

FloatImage Views::drawDome(uint32_t width, uint32_t height, const WelkinVulkanView& view) {
  Offscreen target(device_, width, height);
  return target.render([&](VkCommandBuffer commands) {
    require(welkin_vulkan_draw_dome(runtime_.get(), commands, 0, &view), "welkin_vulkan_draw_dome");
  });
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
  SpheresPush push{};
  const auto matrix = inverseViewProjection(camera, static_cast<double>(width) / height);
  std::copy(matrix.begin(), matrix.end(), push.inverse_view_projection);
  push.aspect = static_cast<float>(width) / static_cast<float>(height);
  push.light = static_cast<uint32_t>(light);
  push.from_cubemaps = source_ == WELKIN_VULKAN_CUBEMAP ? 1 : 0;
  Offscreen target(device_, width, height);
  return target.render([&](VkCommandBuffer commands) {
    spheres_->record(commands, welkin_vulkan_descriptor_set(runtime_.get(), 0), push);
  });
}

Camera Views::towardsLight() const {
  constexpr float kNauticalTwilight = -0.2079F;  // sin of -12 degrees
  const bool moon_only = sample_.sun.direction[1] < kNauticalTwilight && sample_.moon.direction[1] > 0.0F;
  const float* d = moon_only ? sample_.moon.direction : sample_.sun.direction;
  return {std::atan2(static_cast<double>(d[0]), -static_cast<double>(d[2])), 0.0, 1.0};
}

}  // namespace welkin::tools
