// SPDX-License-Identifier: Apache-2.0
#include "render/level_reflection.h"

#include <cstdint>
#include <string>

#include "sky/base/error.h"

namespace welkin::render {

LevelReflection::LevelReflection(const VulkanDevice& device, const RuntimeSky& sky) : sky_(sky) {
  const WelkinVulkanCreateInfo info = createInfo(device, 1);
  WelkinVulkanReflection* chain = nullptr;
  WelkinMessage message{};
  if (welkin_vulkan_reflection_create(&info, sky.get(), kSize, &chain, &message) != WELKIN_OK)
    throw base::Error(base::ExitStatus::file, std::string("Vulkan: ") + message.text);
  chain_.reset(chain);
}

void LevelReflection::record(VkCommandBuffer commands) {
  require(welkin_vulkan_reflection_record(chain_.get(), commands, sky_.get(), 0, UINT32_MAX, nullptr),
          "welkin_vulkan_reflection_record");
}

}  // namespace welkin::render
