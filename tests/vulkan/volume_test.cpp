// SPDX-License-Identifier: Apache-2.0
// The volume on the device against the same texels on the CPU, while camera, light and sectors change.
#include <welkin/welkin_vulkan_volume.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "compute.h"
#include "device_volume.h"
#include "spirv/kVolumeComp.h"
#include "tests/runtime/random_level.h"

namespace welkin::tests {
namespace {

std::vector<float> pointsAbout(const std::array<float, 3>& camera, std::mt19937& random) {
  const auto in = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(random); };
  std::vector<float> points;
  for (int i = 0; i < 256; ++i) {
    // Some lie outside, or within the border where the sky takes over.
    points.insert(points.end(), {camera[0] + in(-55, 55), camera[1] + in(-20, 20), camera[2] + in(-45, 45), 0.0F});
    float n[3] = {in(-1, 1), in(-1, 1), in(-1, 1)};
    const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    points.insert(points.end(), {n[0] / length, n[1] / length, n[2] / length, 0.0F});
  }
  return points;
}

/// Largest difference of the device's light from the CPU's, relative to the largest irradiance.
double differenceOf(render::VulkanDevice& device, const DeviceVolume& v, uint32_t frame,
                    const std::vector<float>& points) {
  const std::vector<float> found = runCompute(device, kVolumeComp, points, points.size() / 2, 4,
                                              welkin_vulkan_volume_descriptor_set_layout(v.textures),
                                              welkin_vulkan_volume_descriptor_set(v.textures, frame));
  double worst = 0.0, largest = 0.0, shares = 0.0;
  for (std::size_t i = 0; i < points.size() / 8; ++i) {
    float rgb[3], inside = 0.0F;
    REQUIRE(welkin_volume_irradiance(v.volume, &points[8 * i], &points[8 * i + 4], rgb, &inside) == WELKIN_OK);
    for (std::size_t c = 0; c < 3; ++c) {
      largest = std::max(largest, double{rgb[c]});
      worst = std::max(worst, std::abs(double{rgb[c]} - double{found[4 * i + c]}));
    }
    shares = std::max(shares, std::abs(double{inside} - double{found[4 * i + 3]}));
  }
  CHECK(shares < 1e-5);  // floats of positions within 300 m, over a border of 8 m
  REQUIRE(largest > 0.0);
  return worst / largest;
}

}  // namespace

TEST_CASE("VolumeOnTheDevice, ItLightsAsTheTexelsOnTheCpu", "[vulkan]") {
  const RandomLevel baked(3, 60, 6, transfer::SunTransfer::directional, false);
  for (const WelkinVolumeFormat format : {WELKIN_VOLUME_RGBA16F, WELKIN_VOLUME_RGBA8}) {
    OpenedLevel opened(baked);
    render::VulkanDevice device(true);
    {
      DeviceVolume v(device, format);
      std::mt19937 random(11);
      std::array<float, 3> camera = {10, 12, 30};
      WelkinSkySample sample = opened.relight(9.0);
      double worst = 0.0;
      for (uint32_t turn = 0; turn < 12; ++turn) {
        if (turn % 3 == 2) sample = opened.relight(9.0 + turn);
        if (turn == 6) {  // a sector leaves, and comes back later
          WelkinSector* sector = nullptr;
          REQUIRE(welkin_level_remove(opened.level, 0, 0, &sector) == WELKIN_OK);
          welkin_sector_close(sector);
        }
        for (float& c : camera) c += std::uniform_real_distribution<float>(-7, 7)(random);
        v.update(device, opened.level, sample, camera.data(), turn % DeviceVolume::kFrames, 24 * 8 * 6);
        worst = std::max(worst, differenceOf(device, v, turn % DeviceVolume::kFrames, pointsAbout(camera, random)));
      }
      // lavapipe filters halfs in floats, and bytes with weights of 8 bits along each of three axes. The weights of the
      // four directions sum to 2 at most, and a random level's neighbours differ by all of the scale.
      INFO("format " << format << ", worst " << worst);
      CHECK(worst < (format == WELKIN_VOLUME_RGBA16F ? 1e-4 : 2.0 * 3.0 / 255.0));
    }
    CHECK(device.messageCount() == 0);
  }
}

TEST_CASE("VolumeOnTheDevice, RefusesUpdatesThatAreNotItsOwn", "[vulkan]") {
  const RandomLevel baked(1, 20, 0, transfer::SunTransfer::none, false);
  OpenedLevel opened(baked);
  render::VulkanDevice device(true);
  {
    DeviceVolume v(device, WELKIN_VOLUME_RGBA16F);
    const WelkinSkySample sample = opened.relight(9.0);
    const float camera[3] = {0, 0, 0};
    WelkinVolumeUpdate first{};
    REQUIRE(welkin_volume_update(v.volume, opened.level, &sample, camera, UINT32_MAX, &first) == WELKIN_OK);
    device.execute([&](VkCommandBuffer commands) {
      WelkinVolumeUpdate none{};
      CHECK(welkin_vulkan_volume_record(v.textures, commands, 0, v.volume, &none) == WELKIN_ERROR_ARGUMENT);
      CHECK_THAT(welkin_argument_error(), Catch::Contains("must fill the whole volume"));
      WelkinVolumeUpdate wordless = first;
      wordless.cut_bytes = 0;
      CHECK(welkin_vulkan_volume_record(v.textures, commands, 0, v.volume, &wordless) == WELKIN_ERROR_ARGUMENT);
      WelkinVolumeUpdate past = first;
      past.box[0].size[1] += 1;
      CHECK(welkin_vulkan_volume_record(v.textures, commands, 0, v.volume, &past) == WELKIN_ERROR_ARGUMENT);
      CHECK(welkin_vulkan_volume_record(v.textures, commands, DeviceVolume::kFrames, v.volume, &first) ==
            WELKIN_ERROR_ARGUMENT);
      CHECK(welkin_vulkan_volume_record(v.textures, commands, 0, v.volume, &first) == WELKIN_OK);
    });
    WelkinVulkanMemory memory{};
    REQUIRE(welkin_vulkan_volume_memory(v.textures, &memory) == WELKIN_OK);
    CHECK(memory.images >= 3 * 24 * 8 * 20 * 8);
    CHECK(welkin_vulkan_volume_descriptor_set(v.textures, DeviceVolume::kFrames) == VK_NULL_HANDLE);
    CHECK(welkin_vulkan_volume_descriptor_set_layout(nullptr) == VK_NULL_HANDLE);
  }
  CHECK(device.messageCount() == 0);
}

}  // namespace welkin::tests
