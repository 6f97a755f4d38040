// SPDX-License-Identifier: Apache-2.0
// The far map on the device against its texels on the CPU, while the camera moves and sectors come and go; and the
// whole ambient pass across the volume's border.
#include <welkin/welkin_vulkan_volume.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "compute.h"
#include "device_volume.h"
#include "spirv/kFarComp.h"
#include "spirv/kFarFrameComp.h"
#include "tests/runtime/random_level.h"

namespace welkin::tests {
namespace {

void addPoint(std::vector<float>& points, const std::array<float, 3>& p, const std::array<float, 3>& n) {
  points.insert(points.end(), {p[0], p[1], p[2], 0.0F, n[0], n[1], n[2], 0.0F});
}

std::array<float, 3> randomNormal(std::mt19937& random) {
  std::uniform_real_distribution<float> in(-1, 1);
  const float n[3] = {in(random), in(random), in(random)};
  const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  return {n[0] / length, n[1] / length, n[2] / length};
}

std::vector<float> compute(render::VulkanDevice& device, std::span<const uint32_t> pass, const DeviceVolume& v,
                           uint32_t frame, const std::vector<float>& points) {
  return runCompute(device, pass, points, points.size() / 2, 4, welkin_vulkan_volume_descriptor_set_layout(v.textures),
                    welkin_vulkan_volume_descriptor_set(v.textures, frame));
}

float visibilityOf(const DeviceVolume& v, const float* point) {
  float visibility = -1.0F;
  REQUIRE(welkin_volume_far_visibility(v.volume, point, point + 4, &visibility) == WELKIN_OK);
  return visibility;
}

/// Takes a sector away, or brings it back.
void toggle(OpenedLevel& opened, std::int32_t x) {
  WelkinSector* sector = nullptr;
  REQUIRE(welkin_level_remove(opened.level, x, 0, &sector) == WELKIN_OK);
  if (sector != nullptr) return welkin_sector_close(sector);
  const AlignedBytes& file = opened.files[static_cast<std::size_t>(2 + x + 1)];
  REQUIRE(welkin_sector_open(opened.level, file.data(), file.size, &sector, nullptr) == WELKIN_OK);
  REQUIRE(welkin_level_add(opened.level, sector) == WELKIN_OK);
}

/// Probes all at one height, so that most points about it feel the map.
RandomLevel lowLevel(int sectors) {
  RandomLevel baked(sectors, 60, 0, transfer::SunTransfer::none, false);
  for (auto& s : baked.sector) {
    s.probes.high_y = 6.0F;
    std::fill(s.probes.sky.begin(), s.probes.sky.end(), std::uint8_t{0});  // no light bounces
    std::fill(s.probes.sky_side.begin(), s.probes.sky_side.end(), std::int8_t{0});
  }
  baked.reindex();
  return baked;
}

}  // namespace

TEST_CASE("FarMapOnTheDevice, ItHidesTheSkyAsTheTexelsOnTheCpu", "[vulkan]") {
  const RandomLevel baked = lowLevel(7);
  for (const WelkinVolumeFormat format : {WELKIN_VOLUME_RGBA16F, WELKIN_VOLUME_DEVICE}) {
    OpenedLevel opened(baked);
    render::VulkanDevice device(true);
    {
      const DeviceVolume v(device, format, {8, 4, 8}, WELKIN_VOLUME_NO_BRICKS, 64);
      std::mt19937 random(11);
      const auto in = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(random); };
      std::array<float, 3> camera = {10, 6, 30};
      const WelkinSkySample sample = opened.relight(9.0);
      double worst = 0.0, lowest = 1.0;
      for (uint32_t turn = 0; turn < 12; ++turn) {
        if (turn % 3 == 2) toggle(opened, static_cast<std::int32_t>(turn) / 4);
        camera[0] += in(0, 60);
        camera[2] += in(-30, 30);
        v.update(device, opened.level, sample, camera.data(), turn % DeviceVolume::kFrames, 8 * 4 * 3);
        std::vector<float> points;
        for (int i = 0; i < 256; ++i)
          addPoint(points, {camera[0] + in(-150, 150), in(-8, 16), camera[2] + in(-150, 150)}, randomNormal(random));
        const auto found = compute(device, kFarComp, v, turn % DeviceVolume::kFrames, points);
        for (std::size_t i = 0; i < 256; ++i) {
          const double wanted = double{visibilityOf(v, &points[8 * i])};
          worst = std::max(worst, std::abs(double{found[4 * i]} - wanted));
          lowest = std::min(lowest, wanted);
        }
      }
      INFO("format " << format << ", worst " << worst);
      // lavapipe filters halfs in floats; the fade of 8 m multiplies the rounding of heights.
      CHECK(worst < 1e-4);
      CHECK(lowest < 0.5);
    }
    CHECK(device.messageCount() == 0);
  }
}

TEST_CASE("FarMapOnTheDevice, TheAmbientPassHasNoStepAtTheBorders", "[vulkan]") {
  const RandomLevel baked = lowLevel(6);
  OpenedLevel opened(baked);
  render::VulkanDevice device(true);
  {
    const DeviceVolume v(device, WELKIN_VOLUME_RGBA16F, {16, 8, 16}, WELKIN_VOLUME_NO_BRICKS, 96);
    const WelkinSkySample sample = opened.relight(9.0);
    const float camera[3] = {97.3F, 6.0F, 33.1F};
    v.update(device, opened.level, sample, camera, 0);
    constexpr float kStep_m = 1.0F / 64.0F;
    std::vector<float> points;  // east of the camera, through the volume's border to beyond the map's
    for (int i = 0; i < 64 * 180; ++i)
      addPoint(points, {camera[0] + kStep_m * static_cast<float>(i), 6.0F, camera[2]}, {0.6F, 0.8F, 0.0F});
    const auto found = compute(device, kFarFrameComp, v, 0, points);
    double worst = 0.0, largest = 0.0, step = 0.0;
    std::size_t inside = 0, both = 0, beyond = 0, open = 0;
    for (std::size_t i = 0; i < points.size() / 8; ++i) {
      float rgb[3], share = 0.0F;
      REQUIRE(welkin_volume_irradiance(v.volume, &points[8 * i], &points[8 * i + 4], rgb, &share) == WELKIN_OK);
      const float visibility = visibilityOf(v, &points[8 * i]);
      ++(share == 1.0F ? inside : share > 0.0F ? both : visibility < 1.0F ? beyond : open);
      for (std::size_t c = 0; c < 3; ++c) {
        const double wanted = double{share} * double{rgb[c]} + (1.0 - double{share}) * double{visibility};
        worst = std::max(worst, std::abs(double{found[4 * i + c]} - wanted));
        largest = std::max(largest, wanted);
        if (i > 0) step = std::max(step, std::abs(double{found[4 * i + c]} - double{found[4 * (i - 1) + c]}));
      }
    }
    INFO("inside " << inside << " both " << both << " beyond " << beyond << " open " << open << "; largest " << largest
                   << ", step " << step << ", worst " << worst);
    CHECK(worst < 1e-4 * largest);
    // Light may go from all to nothing over a texel of 4 m, of which a step is 1/256, and so may both shares and the
    // fade.
    CHECK(step < 4.0 / 256.0 * largest);
    CHECK((inside > 1000 && both > 100 && beyond > 4000 && open > 1000));
  }
  CHECK(device.messageCount() == 0);
}

TEST_CASE("FarMapOnTheDevice, AGameOfTheFirstReleaseHasTheWholeMap", "[vulkan]") {
  const RandomLevel baked = lowLevel(4);
  OpenedLevel opened(baked);
  render::VulkanDevice device(true);
  {
    const DeviceVolume v(device, WELKIN_VOLUME_RGBA16F, {8, 4, 8}, WELKIN_VOLUME_NO_BRICKS, 64);
    const WelkinSkySample sample = opened.relight(9.0);
    const float camera[3] = {30, 6, 30};
    for (int turn = 0; turn < 3; ++turn) {
      if (turn > 0) toggle(opened, 1);
      WelkinVolumeUpdate update{};
      update.struct_size = offsetof(WelkinVolumeUpdate, far_box_count);
      REQUIRE(welkin_volume_update(v.volume, opened.level, &sample, camera, UINT32_MAX, &update) == WELKIN_OK);
      device.execute([&](VkCommandBuffer commands) {
        CHECK(welkin_vulkan_volume_record(v.textures, commands, 0, v.volume, &update) == WELKIN_OK);
      });
      std::vector<float> points;
      for (float x = 50; x < 140; x += 3.7F) addPoint(points, {x, 3, 30}, {0, 1, 0});
      const auto found = compute(device, kFarComp, v, 0, points);
      for (std::size_t i = 0; i < points.size() / 8; ++i)
        CHECK(double{found[4 * i]} == Approx(double{visibilityOf(v, &points[8 * i])}).margin(1e-4));
    }
  }
  CHECK(device.messageCount() == 0);
}

TEST_CASE("FarMapOnTheDevice, RefusesRectanglesThatPassIt", "[vulkan]") {
  const RandomLevel baked = lowLevel(1);
  OpenedLevel opened(baked);
  render::VulkanDevice device(true);
  {
    const DeviceVolume v(device, WELKIN_VOLUME_RGBA16F, {8, 4, 8}, WELKIN_VOLUME_NO_BRICKS, 64);
    const WelkinSkySample sample = opened.relight(9.0);
    const float camera[3] = {30, 6, 30};
    WelkinVolumeUpdate first{};
    REQUIRE(welkin_volume_update(v.volume, opened.level, &sample, camera, UINT32_MAX, &first) == WELKIN_OK);
    device.execute([&](VkCommandBuffer commands) {
      const auto refused = [&](const WelkinVolumeUpdate& update, const char* why) {
        CHECK(welkin_vulkan_volume_record(v.textures, commands, 0, v.volume, &update) == WELKIN_ERROR_ARGUMENT);
        CHECK_THAT(welkin_argument_error(), Catch::Contains(why));
      };
      WelkinVolumeUpdate wrong = first;
      wrong.far_box[0].size[1] = 65;
      refused(wrong, "far_box[0] passes the far map");
      wrong = first;
      wrong.far_box[0].first[0] = 64;
      refused(wrong, "far_box[0] passes the far map");
      wrong = first;
      wrong.far_box_count = 9;
      refused(wrong, "far_box_count is 9, must be at most 8");
      CHECK(welkin_vulkan_volume_record(v.textures, commands, 0, v.volume, &first) == WELKIN_OK);
    });
  }
  CHECK(device.messageCount() == 0);
}

}  // namespace welkin::tests
