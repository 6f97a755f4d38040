// SPDX-License-Identifier: Apache-2.0
// Probes that the device relights, and texels that it fills, against those of the CPU.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "compute.h"
#include "device_volume.h"
#include "spirv/kVolumeComp.h"
#include "tests/runtime/random_level.h"
#include "wall_level.h"

namespace welkin::tests {
namespace {

using Points = std::vector<float>;  ///< position, 0, normal, 0

Points pointsIn(const std::array<float, 3>& low, const std::array<float, 3>& high, std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  const auto in = [&](float a, float b) { return std::uniform_real_distribution<float>(a, b)(random); };
  Points points;
  while (points.size() < 8 * count) {
    const float n[3] = {in(-1, 1), in(-1, 1), in(-1, 1)};
    const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (length < 0.1F) continue;
    points.insert(points.end(), {in(low[0], high[0]), in(low[1], high[1]), in(low[2], high[2]), 0.0F});
    points.insert(points.end(), {n[0] / length, n[1] / length, n[2] / length, 0.0F});
  }
  return points;
}

std::vector<float> lightAt(render::VulkanDevice& device, const DeviceVolume& v, std::uint32_t frame,
                           const Points& points) {
  return runCompute(device, kVolumeComp, points, points.size() / 2, 4,
                    welkin_vulkan_volume_descriptor_set_layout(v.textures),
                    welkin_vulkan_volume_descriptor_set(v.textures, frame));
}

/// Largest difference of two lists of light, over the largest light.
double apart(const std::vector<float>& a, const std::vector<float>& b) {
  REQUIRE(a.size() == b.size());
  double worst = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (i % 4 == 3) continue;  // the volume's share
    worst = std::max(worst, std::abs(double{a[i]} - double{b[i]}));
    largest = std::max(largest, double{b[i]});
  }
  REQUIRE(largest > 0.0);
  return worst / largest;
}

/// The device's halfs may be cut where the CPU rounds: 2^-10 of a texel, whose four weights sum to 2 at most in size.
constexpr double kStepOfHalfs = 2.0 / 1024.0;

}  // namespace

TEST_CASE("VolumeRelight, TheDeviceRelightsAndFillsAsTheCpu", "[vulkan]") {
  for (const std::size_t modes : {6U, 16U, 0U}) {
    const auto sun = modes == 0 ? transfer::SunTransfer::sh : transfer::SunTransfer::directional;
    RandomLevel baked(3, modes == 16 ? 255 : 61, modes, sun, modes != 16);
    OpenedLevel opened(baked);
    render::VulkanDevice device(true);
    {
      const DeviceVolume cpu(device, WELKIN_VOLUME_RGBA16F), gpu(device, WELKIN_VOLUME_DEVICE);
      std::mt19937 random(11);
      std::array<float, 3> camera = {10, 12, 30};
      WelkinSkySample sample = opened.relight(9.0);
      WelkinSector* away = nullptr;
      double worst = 0.0;
      for (std::uint32_t turn = 0; turn < 12; ++turn) {
        if (turn == 5) REQUIRE(welkin_level_remove(opened.level, 0, 0, &away) == WELKIN_OK);
        if (turn == 8) REQUIRE(welkin_level_add(opened.level, away) == WELKIN_OK);
        if (turn % 3 == 2) sample = opened.relight(turn == 8 ? 0.5 : 9.0 + turn, 0.7F, 1.3F, 2.0F);
        for (float& c : camera) c += std::uniform_real_distribution<float>(-7, 7)(random);
        const std::uint32_t frame = turn % DeviceVolume::kFrames;
        cpu.update(device, opened.level, sample, camera.data(), frame);
        gpu.update(device, opened.level, sample, camera.data(), frame, 1);
        const Points points = pointsIn({camera[0] - 55, camera[1] - 20, camera[2] - 45},
                                       {camera[0] + 55, camera[1] + 20, camera[2] + 45}, 256, turn);
        worst = std::max(worst, apart(lightAt(device, gpu, frame, points), lightAt(device, cpu, frame, points)));
      }
      INFO(modes << " modes, worst " << worst);
      CHECK(worst < kStepOfHalfs);
      CHECK(worst > 0.0);  // two ways, not one
    }
    CHECK(device.messageCount() == 0);
  }
}

TEST_CASE("VolumeRelight, ALampOnTheDeviceLightsAsOnTheCpu", "[vulkan]") {
  RandomLevel baked(2, 40, 6, transfer::SunTransfer::directional, true);
  baked.addLocal(20, 12);
  OpenedLevel opened(baked);
  render::VulkanDevice device(true);
  {
    const DeviceVolume cpu(device, WELKIN_VOLUME_RGBA16F), gpu(device, WELKIN_VOLUME_DEVICE);
    const float camera[3] = {0, 4, 30};
    const Points points = pointsIn({-40, 0, 0}, {40, 8, 60}, 512, 3);
    std::vector<float> before;
    for (std::uint32_t turn = 0; turn < 3; ++turn) {
      WelkinPointLight lamp{};
      lamp.position[0] = -20.0F + 15.0F * static_cast<float>(turn);
      lamp.position[1] = 3.0F;
      lamp.position[2] = 30.0F;
      for (float& i : lamp.intensity) i = 300.0F;
      WelkinLightsResult result{};
      REQUIRE(welkin_level_set_lights(opened.level, 1, &lamp, nullptr, nullptr, &result) == WELKIN_OK);
      const WelkinSkySample sample = opened.relight(0.5);
      cpu.update(device, opened.level, sample, camera, 0);
      gpu.update(device, opened.level, sample, camera, 0);
      const auto found = lightAt(device, gpu, 0, points);
      CHECK(apart(found, lightAt(device, cpu, 0, points)) < kStepOfHalfs);
      CHECK(found != before);
      before = found;
    }
  }
  CHECK(device.messageCount() == 0);
}

TEST_CASE("VolumeRelight, BricksOfWallsHoldOnTheDevice", "[vulkan]") {
  LeakLevel place = leakLevel("hall 20 x 12 m", 1);
  move(place, Number3(-30.0, 0.0, 0.0));  // across the border at x = 0
  OpenedLevel opened(bakedLevel(place.surfaces, {{-1, 0}, {0, 0}}));
  render::VulkanDevice device(true);
  {
    const DeviceVolume cpu(device, WELKIN_VOLUME_RGBA16F), gpu(device, WELKIN_VOLUME_DEVICE);
    Points inside;
    for (const LeakPoint& p : place.point)
      if (p.push_m == 1.0)
        for (const Number3& v : {p.position, p.normal})
          inside.insert(inside.end(),
                        {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), 0.0F});
    const Points about = pointsIn({-40, 0, 20}, {30, 9, 60}, 512, 5);
    WelkinSkySample sample = opened.relight(12.0);
    for (std::uint32_t turn = 0; turn < 6; ++turn) {
      if (turn == 3) {  // the sector comes again, in another slot of the level
        WelkinSector* sector = nullptr;
        REQUIRE(welkin_level_remove(opened.level, -1, 0, &sector) == WELKIN_OK);
        const float camera[3] = {-4, 4, 40};
        gpu.update(device, opened.level, sample, camera, 0);
        REQUIRE(welkin_level_add(opened.level, sector) == WELKIN_OK);
      }
      sample = opened.relight(9.0 + turn);
      const float camera[3] = {-4.0F + 3.0F * static_cast<float>(turn), 4, 40};
      cpu.update(device, opened.level, sample, camera, 0);
      const WelkinVolumeUpdate update = gpu.update(device, opened.level, sample, camera, 0);
      INFO("turn " << turn);
      CHECK(update.bricks > 0);
      CHECK(update.cuts_left == 0);
      const auto dark = lightAt(device, gpu, 0, inside);
      for (std::size_t i = 1; i < dark.size(); i += 4) REQUIRE(dark[i] == 0.0F);
      CHECK(apart(lightAt(device, gpu, 0, about), lightAt(device, cpu, 0, about)) < kStepOfHalfs);
    }
  }
  CHECK(device.messageCount() == 0);
}

TEST_CASE("VolumeRelight, AUniformSkyIsThatOfTheCpuInEveryTexelBeyondTheSectors", "[vulkan]") {
  const RandomLevel baked(1, 20, 0, transfer::SunTransfer::none, false);
  OpenedLevel opened(baked);
  render::VulkanDevice device(true);
  {
    const DeviceVolume cpu(device, WELKIN_VOLUME_RGBA16F), gpu(device, WELKIN_VOLUME_DEVICE);
    const float far[3] = {3000, 10, 3000};
    const WelkinSkySample sample = opened.relight(9.0);
    cpu.update(device, opened.level, sample, far, 0);
    const WelkinVolumeUpdate first = gpu.update(device, opened.level, sample, far, 0);
    CHECK(first.filled >= 24 * 8 * 20);
    const Points points = pointsIn({2970, 0, 2970}, {3030, 20, 3030}, 128, 1);
    CHECK(apart(lightAt(device, gpu, 0, points), lightAt(device, cpu, 0, points)) < kStepOfHalfs);
    const WelkinVolumeUpdate again = gpu.update(device, opened.level, sample, far, 0);
    CHECK(again.box_count == 0);
    CHECK(again.remaining == 0);
    // Another hour changes no word, and all texels.
    const WelkinSkySample noon = opened.relight(12.0);
    cpu.update(device, opened.level, noon, far, 0);
    CHECK(gpu.update(device, opened.level, noon, far, 0).box_count == 0);
    CHECK(apart(lightAt(device, gpu, 0, points), lightAt(device, cpu, 0, points)) < kStepOfHalfs);
    const void* texels = nullptr;
    std::size_t bytes = 0;
    CHECK(welkin_volume_texels(gpu.volume, 0, &texels, &bytes) == WELKIN_ERROR_ARGUMENT);
    CHECK_THAT(welkin_argument_error(), Catch::Contains("only the device has its texels"));
    const float p[3] = {0, 0, 0}, n[3] = {0, 1, 0};
    float rgb[3];
    CHECK(welkin_volume_irradiance(gpu.volume, p, n, rgb, nullptr) == WELKIN_ERROR_ARGUMENT);
    WelkinVulkanMemory of_cpu{}, of_gpu{};
    REQUIRE(welkin_vulkan_volume_memory(cpu.textures, &of_cpu) == WELKIN_OK);
    REQUIRE(welkin_vulkan_volume_memory(gpu.textures, &of_gpu) == WELKIN_OK);
    CHECK(of_gpu.images > of_cpu.images);
  }
  CHECK(device.messageCount() == 0);
}

}  // namespace welkin::tests
