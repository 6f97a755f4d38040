// SPDX-License-Identifier: Apache-2.0
// Rooms with a closed form, baked, relit and lit per pixel on the device: a furnace, and the same room in the dark.
#include <algorithm>
#include <catch2/catch.hpp>

#include "compute.h"
#include "device_volume.h"
#include "spirv/kVolumeComp.h"
#include "tests/probes/rooms.h"
#include "wall_level.h"

namespace welkin::tests {
namespace {

const Number3 kRoomLow(18, 0, 22), kRoomHigh(33, 5, 41);

/// Ground under a bright sky, and a closed room on it with walls of 0.1 m that shine inside.
geometry::Surfaces roomOf(const Number3& albedo, const Number3& emission) {
  geometry::Surfaces s;
  const std::uint32_t plain = addMaterial(s, Number3(0.3));
  const Number3 wall(0.1), low = kRoomLow - wall, high = kRoomHigh + wall;
  // Around the room, not under it.
  addQuad(s, {-40, 0, -40}, {0, 0, 160}, {low.x + 40, 0, 0}, plain);
  addQuad(s, {high.x, 0, -40}, {0, 0, 160}, {120 - high.x, 0, 0}, plain);
  addQuad(s, {low.x, 0, -40}, {0, 0, low.z + 40}, {high.x - low.x, 0, 0}, plain);
  addQuad(s, {low.x, 0, high.z}, {0, 0, 120 - high.z}, {high.x - low.x, 0, 0}, plain);
  addBoxOutside(s, low, high, plain);
  addBoxInside(s, kRoomLow, kRoomHigh, addMaterial(s, albedo, false, emission));
  return s;
}

/// Pixels of all six surfaces, eight floats each: position, 0, normal, 0.
std::vector<float> pixelsOfRoom() {
  constexpr int kPixelsAcross = 24;
  std::vector<float> pixels;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {0.0, 1.0})
      for (int i = 0; i < kPixelsAcross * kPixelsAcross; ++i) {
        Number3 share(0.0), normal(0.0);
        share[axis] = side;
        share[(axis + 1) % 3] = (i % kPixelsAcross + 0.5) / kPixelsAcross;
        share[(axis + 2) % 3] = (i / kPixelsAcross + 0.5) / kPixelsAcross;
        normal[axis] = 1.0 - 2.0 * side;
        const Number3 place = kRoomLow + share * (kRoomHigh - kRoomLow);
        for (const Number3& v : {place, normal})
          pixels.insert(pixels.end(),
                        {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), 0.0F});
      }
  return pixels;
}

/// Least and most of each channel over all pixels.
struct Range {
  float least[3] = {1e9F, 1e9F, 1e9F}, most[3] = {};
};

Range rangeOf(render::VulkanDevice& device, const RandomLevel& baked, WelkinVolumeFormat format) {
  OpenedLevel opened(baked);
  const DeviceVolume v(device, format);
  const float camera[3] = {25, 3, 30};
  const WelkinVolumeUpdate update = v.update(device, opened.level, opened.relight(12.0), camera, 0);
  CHECK(update.cuts_left == 0);
  const std::vector<float> pixels = pixelsOfRoom();
  const auto light = runCompute(device, kVolumeComp, pixels, pixels.size() / 2, 4,
                                welkin_vulkan_volume_descriptor_set_layout(v.textures),
                                welkin_vulkan_volume_descriptor_set(v.textures, 0));
  Range range;
  for (std::size_t i = 0; i < light.size(); ++i) {
    if (i % 4 == 3) continue;
    range.least[i % 4] = std::min(range.least[i % 4], light[i]);
    range.most[i % 4] = std::max(range.most[i % 4], light[i]);
  }
  return range;
}

}  // namespace

TEST_CASE("VolumeFurnace, EveryPixelOfAWhiteRoomIsEqual", "[vulkan]") {
  const Number3 emission(0.2, 0.5, 1.0);
  const RandomLevel baked = bakedLevel(roomOf(Number3(0.5), emission), {{0, 0}}, 2);
  render::VulkanDevice device(true);
  for (const WelkinVolumeFormat format : {WELKIN_VOLUME_RGBA16F, WELKIN_VOLUME_DEVICE}) {
    const Range range = rangeOf(device, baked, format);
    for (std::size_t c = 0; c < 3; ++c) {
      // Emission, and two bounces off an albedo of a half.
      const double expected = f64::kPi * emission[static_cast<int>(c)] * (1.0 + 0.5 + 0.25);
      INFO("format " << format << ", channel " << c << ": " << range.least[c] << " to " << range.most[c] << " for "
                     << expected);
      // Half a step of 255 of the brightest channel in each of four numbers, whose weights' sizes sum to 2 at most.
      const double step = f64::kPi * 1.75 / 255.0;
      CHECK(double{range.least[c]} > expected - step);
      CHECK(double{range.most[c]} < expected + step);
    }
  }
  CHECK(device.messageCount() == 0);
}

TEST_CASE("VolumeFurnace, AClosedRoomUnderABrightSkyIsBlackInEveryPixel", "[vulkan]") {
  const RandomLevel baked = bakedLevel(roomOf(Number3(0.5), Number3(0.0)), {{0, 0}}, 2);
  render::VulkanDevice device(true);
  for (const WelkinVolumeFormat format : {WELKIN_VOLUME_RGBA16F, WELKIN_VOLUME_RGBA8, WELKIN_VOLUME_DEVICE}) {
    INFO("format " << format);
    const Range range = rangeOf(device, baked, format);
    for (const float most : range.most) CHECK(most == 0.0F);
  }
  CHECK(device.messageCount() == 0);
}

}  // namespace welkin::tests
