// SPDX-License-Identifier: Apache-2.0
#include "render/level_volume.h"

#include <cstdint>
#include <cstring>
#include <string>

#include "render/runtime_sky.h"
#include "sky/base/error.h"

namespace welkin::render {

LevelVolume::LevelVolume(VulkanDevice& device, WelkinLevel& level, const ProbeParts& parts)
    : device_(device), level_(level), parts_(parts) {
  WelkinVolumeSettings settings{};
  WelkinVolume* volume = nullptr;
  require(welkin_volume_create(&settings, &volume), "welkin_volume_create");
  volume_.reset(volume);
  const WelkinVulkanCreateInfo info = createInfo(device, 1);
  WelkinVulkanVolume* textures = nullptr;
  WelkinMessage message{};
  if (welkin_vulkan_volume_create(&info, volume, &textures, &message) != WELKIN_OK)
    throw base::Error(base::ExitStatus::file, std::string("Vulkan: ") + message.text);
  textures_.reset(textures);
}

void LevelVolume::update(const WelkinSkySample& sample, const f64::Number3& position) {
  const Lit wanted{sample, parts_};
  if (!lit_ || std::memcmp(&lit_->sample, &wanted.sample, sizeof(wanted.sample)) != 0 ||
      std::memcmp(&lit_->parts, &wanted.parts, sizeof(wanted.parts)) != 0) {
    lit_.reset();
    WelkinLevelLight light{};
    light.sample = &sample;
    light.sky = parts_.sky;
    light.sun_bounce = parts_.sun_bounce;
    light.local = parts_.local;
    require(welkin_level_set_light(&level_, &light), "welkin_level_set_light");
    require(welkin_level_relight(&level_, UINT32_MAX, nullptr), "welkin_level_relight");
    lit_ = wanted;
  }
  const float camera[3] = {static_cast<float>(position.x), static_cast<float>(position.y),
                           static_cast<float>(position.z)};
  WelkinVolumeUpdate update{};
  require(welkin_volume_update(volume_.get(), &level_, &sample, camera, UINT32_MAX, &update), "welkin_volume_update");
  device_.execute([&](VkCommandBuffer commands) {
    require(welkin_vulkan_volume_record(textures_.get(), commands, 0, volume_.get(), &update),
            "welkin_vulkan_volume_record");
  });
}

}  // namespace welkin::render
