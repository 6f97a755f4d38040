// SPDX-License-Identifier: Apache-2.0
// Creates, uploads and updates the runtime's sky.
#include "render/runtime_sky.h"

#include <algorithm>
#include <string>

#include "render/offscreen.h"
#include "sky/base/error.h"

namespace welkin::render {

void require(WelkinResult result, const char* call) {
  if (result != WELKIN_OK)
    throw base::Error(base::ExitStatus::internal, std::string(call) + " failed: " + welkin_result_string(result));
}

WelkinVulkanCreateInfo createInfo(const VulkanDevice& device, uint32_t frames_in_flight) {
  WelkinVulkanCreateInfo info{};
  info.struct_size = sizeof(info);
  info.api_version = VK_API_VERSION_1_3;
  info.get_instance_proc_addr = vkGetInstanceProcAddr;
  info.instance = device.instance();
  info.physical_device = device.physical();
  info.device = device.device();
  info.frames_in_flight = frames_in_flight;
  info.colour_format = Offscreen::kFormat;
  return info;
}

RuntimeSky::RuntimeSky(VulkanDevice& device, const Sky& sky, VkFormat depth_format, VkCompareOp depth_compare)
    : sky_(sky) {
  WelkinVulkanCreateInfo info = createInfo(device, 1);
  info.depth_format = depth_format;
  info.depth_compare = depth_compare;
  WelkinVulkanSky* runtime = nullptr;
  WelkinMessage message{};
  if (welkin_vulkan_create(&info, sky.get(), &runtime, &message) != WELKIN_OK)
    throw base::Error(base::ExitStatus::file, std::string("Vulkan: ") + message.text);
  runtime_.reset(runtime);
  device.execute(
      [&](VkCommandBuffer commands) { require(welkin_vulkan_record_upload(runtime, commands), "record_upload"); });
  welkin_vulkan_free_staging(runtime);
}

void RuntimeSky::setTime(double time_h, bool tint) {
  if (!sky_.sample(time_h, sample_))
    throw base::Error(base::ExitStatus::usage, "the time must be a finite number of hours");
  if (!tint) std::fill_n(sample_.polarising_tint, 3, 1.0F);
  require(welkin_vulkan_update(runtime_.get(), 0, &sample_), "welkin_vulkan_update");
}

void RuntimeSky::setSample(const WelkinSkySample& sample) {
  sample_ = sample;
  require(welkin_vulkan_update(runtime_.get(), 0, &sample_), "welkin_vulkan_update");
}

void RuntimeSky::recordDome(VkCommandBuffer commands, const WelkinVulkanView& view) const {
  require(welkin_vulkan_draw_dome(runtime_.get(), commands, 0, &view), "welkin_vulkan_draw_dome");
}

}  // namespace welkin::render
