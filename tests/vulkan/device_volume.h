// SPDX-License-Identifier: Apache-2.0
// A volume with its textures on a device.
#pragma once

#include <welkin/welkin_vulkan_volume.h>

#include <algorithm>
#include <array>

#include "render/runtime_sky.h"
#include "render/vulkan_device.h"

namespace welkin::tests {

struct DeviceVolume {
  static constexpr std::uint32_t kFrames = 2;
  WelkinVolume* volume = nullptr;
  WelkinVulkanVolume* textures = nullptr;

  DeviceVolume(const render::VulkanDevice& device, WelkinVolumeFormat format,
               const std::array<std::uint32_t, 3>& texels = {24, 8, 20}, std::uint32_t bricks = 0,
               std::uint32_t far_texels = 0) {
    WelkinVolumeSettings settings{};
    settings.format = format;
    std::copy(texels.begin(), texels.end(), settings.texels);
    settings.bricks = bricks;
    settings.far_texels = far_texels;
    render::require(welkin_volume_create(&settings, &volume), "welkin_volume_create");
    const WelkinVulkanCreateInfo info = render::createInfo(device, kFrames);
    render::require(welkin_vulkan_volume_create(&info, volume, &textures, nullptr), "welkin_vulkan_volume_create");
  }
  DeviceVolume(const DeviceVolume&) = delete;
  DeviceVolume& operator=(const DeviceVolume&) = delete;
  ~DeviceVolume() {
    welkin_vulkan_volume_destroy(textures);
    welkin_volume_destroy(volume);
  }

  /// Updates the volume and its textures.
  WelkinVolumeUpdate update(render::VulkanDevice& device, WelkinLevel* level, const WelkinSkySample& sample,
                            const float* camera, std::uint32_t frame, std::uint32_t max_texels = UINT32_MAX) const {
    WelkinVolumeUpdate update{};
    render::require(welkin_volume_update(volume, level, &sample, camera, max_texels, &update), "welkin_volume_update");
    device.execute([&](VkCommandBuffer commands) {
      render::require(welkin_vulkan_volume_record(textures, commands, frame, volume, &update),
                      "welkin_vulkan_volume_record");
    });
    return update;
  }
};

}  // namespace welkin::tests
