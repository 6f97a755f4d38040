// SPDX-License-Identifier: Apache-2.0
// Doors of rooms in the volume on the device.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "compute.h"
#include "device_volume.h"
#include "spirv/kVolumeDoorsComp.h"
#include "wall_level.h"

namespace welkin::tests {
namespace {

/// A sealed hut with a door in the middle of a wall, where there is none: what is dark and what is lit is known.
struct SealedHut {
  SealedHut() : place(leakLevel("hut 3 x 3 m", 1)) {
    settings = roomsOnly(place);
    const geometry::Box& room = place.room[0];
    door = {Number3(room.low.x + 1.0, room.low.y, room.high.z - 0.5),
            Number3(room.high.x - 1.0, room.low.y + 2.0, room.high.z + 1.0)};
    settings.door = {{room, door}};
  }

  LeakLevel place;
  placement::PlacementSettings settings;
  geometry::Box door;
};

/// Surfaces in a box with normals anywhere, eight floats each.
std::vector<float> surfacesIn(const geometry::Box& box, std::size_t count) {
  std::mt19937 random(6);
  const auto in = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  std::vector<float> points;
  while (points.size() < 8 * count) {
    const Number3 n(in(-1, 1), in(-1, 1), in(-1, 1)),
        p(in(box.low.x, box.high.x), in(box.low.y, box.high.y), in(box.low.z, box.high.z));
    const double length = std::sqrt(dot(n, n));
    if (length < 0.1) continue;
    for (const Number3& v : {p, n / length})
      points.insert(points.end(), {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), 0.0F});
  }
  return points;
}

std::vector<float> lightIn(render::VulkanDevice& device, const DeviceVolume& v, const std::vector<float>& points) {
  return runCompute(device, kVolumeDoorsComp, points, points.size() / 2, 4,
                    welkin_vulkan_volume_descriptor_set_layout(v.textures),
                    welkin_vulkan_volume_descriptor_set(v.textures, 0));
}

}  // namespace

TEST_CASE("VolumeDoors, ASealedRoomIsDarkOffItsDoor", "[vulkan]") {
  const SealedHut hut;
  OpenedLevel opened(bakedLevel(hut.place.surfaces, {{0, 0}}, 0, hut.settings));
  render::VulkanDevice device(true);
  {
    const DeviceVolume v(device, WELKIN_VOLUME_RGBA16F);
    const float camera[3] = {30, 4, 40};
    const WelkinVolumeUpdate update = v.update(device, opened.level, opened.relight(12.0), camera, 0);
    CHECK(update.cuts_left == 0);
    const geometry::Box& room = hut.place.room[0];
    const std::vector<float> points = surfacesIn({room.low, room.high}, 6000);
    const auto found = lightIn(device, v, points);
    const auto open = lightIn(device, v, surfacesIn({{4, 0, 4}, {16, 1, 16}}, 100));
    double brightest = 0.0, most = 0.0;
    for (std::size_t i = 1; i < open.size(); i += 4) brightest = std::max(brightest, double{open[i]});
    std::size_t off = 0, soft = 0;
    for (std::size_t i = 0; i < points.size() / 8; ++i) {
      const Number3 p(points[8 * i], points[8 * i + 1], points[8 * i + 2]);
      const Number3 n(points[8 * i + 4], points[8 * i + 5], points[8 * i + 6]);
      float query[1][3];
      const float at[2][1][3] = {{{points[8 * i], points[8 * i + 1], points[8 * i + 2]}},
                                 {{points[8 * i + 4], points[8 * i + 5], points[8 * i + 6]}}};
      REQUIRE(welkin_level_irradiance(opened.level, 1, at[0], at[1], query, nullptr) == WELKIN_OK);
      // The query takes the room and the share 1 m off the surface, the device 0.25 m.
      if (geometry::contains(room, p + n) && !geometry::contains(hut.door, p + n)) CHECK(query[0][1] == 0.0F);
      if (geometry::contains(room, p + 0.25 * n) && !geometry::contains(hut.door, p + 0.25 * n)) {
        ++off;
        CHECK(found[4 * i + 1] == 0.0F);
      }
      if (!geometry::contains(room, p + 0.25 * n) || !geometry::contains(hut.door, p + 0.25 * n)) continue;
      ++soft;
      most = std::max(most, double{found[4 * i + 1]});
    }
    CHECK(off > 2000);
    CHECK(soft > 100);
    CHECK(most < 0.36 * brightest);  // 0.5 m of 1.5 m are inside: (1/3)^2 (3 - 2/3) = 0.26 of the light at the face
    CHECK(most > 0.15 * brightest);
  }
  CHECK(device.messageCount() == 0);
}

TEST_CASE("VolumeDoors, TheDeviceLightsAsTheTexelsOnTheCpu", "[vulkan]") {
  for (const placement::Walls walls : {placement::Walls::ignore, placement::Walls::cut}) {
    SealedHut hut;
    hut.settings.walls = walls;
    OpenedLevel opened(bakedLevel(hut.place.surfaces, {{0, 0}}, 0, hut.settings));
    render::VulkanDevice device(true);
    {
      const DeviceVolume v(device, WELKIN_VOLUME_RGBA16F);
      const float camera[3] = {30, 4, 40};
      v.update(device, opened.level, opened.relight(12.0), camera, 0);
      const std::vector<float> points = surfacesIn({hut.door.low - Number3(1.0), hut.door.high + Number3(1.0)}, 10000);
      const auto found = lightIn(device, v, points);
      double brightest = 0.0;
      for (std::size_t i = 1; i < found.size(); i += 4) brightest = std::max(brightest, double{found[i]});
      std::size_t off = 0;
      for (std::size_t i = 0; i < points.size() / 8; ++i) {
        float rgb[3];
        REQUIRE(welkin_volume_irradiance(v.volume, &points[8 * i], &points[8 * i + 4], rgb, nullptr) == WELKIN_OK);
        off += std::abs(double{rgb[1]} - double{found[4 * i + 1]}) > 1e-4 * brightest ? 1U : 0U;
      }
      CHECK(brightest > 0.0);
      CHECK(off <= 4);  // of 10,000: within the rounding of a float from a plane, or from a cell's face or the door's
    }
    CHECK(device.messageCount() == 0);
  }
}

}  // namespace welkin::tests
