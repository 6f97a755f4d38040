// SPDX-License-Identifier: Apache-2.0
// Bricks of the volume: light beside thin walls on the device.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "compute.h"
#include "device_volume.h"
#include "spirv/kVolumeComp.h"
#include "spirv/kVolumeUncutComp.h"
#include "wall_level.h"

namespace welkin::tests {
namespace {

/// Positions and normals as the shader takes them: eight floats a point.
using Points = std::vector<float>;

void addPoint(Points& points, const Number3& p, const Number3& n) {
  for (const Number3& v : {p, n})
    points.insert(points.end(), {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), 0.0F});
}

Points innerSurfaces(const LeakLevel& place) {
  Points points;
  for (const LeakPoint& p : place.point)
    if (p.push_m == 1.0) addPoint(points, p.position, p.normal);
  return points;
}

/// Points of the air in a box, whose normals point anywhere.
Points airOf(const Number3& low, const Number3& high, std::size_t count) {
  std::mt19937 random(5);
  const auto in = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  Points points;
  while (points.size() < 8 * count) {
    const Number3 n(in(-1, 1), in(-1, 1), in(-1, 1));
    const double length = std::sqrt(dot(n, n));
    if (length > 0.1) addPoint(points, Number3(in(low.x, high.x), in(low.y, high.y), in(low.z, high.z)), n / length);
  }
  return points;
}

std::vector<float> lightOf(render::VulkanDevice& device, const DeviceVolume& v, const Points& points,
                           std::span<const uint32_t> shader = kVolumeComp) {
  return runCompute(device, shader, points, points.size() / 2, 4,
                    welkin_vulkan_volume_descriptor_set_layout(v.textures),
                    welkin_vulkan_volume_descriptor_set(v.textures, 0));
}

/// The most of green of all points.
double brightest(const std::vector<float>& light) {
  double most = 0.0;
  for (std::size_t i = 1; i < light.size(); i += 4) most = std::max(most, double{light[i]});
  return most;
}

}  // namespace

TEST_CASE("VolumeBricks, NoLightPassesThinWalls", "[vulkan]") {
  for (const char* shape : {"hall 20 x 12 m", "hut, turned by 17", "corridor 0.8 m", "below a floor"}) {
    const LeakLevel place = leakLevel(shape, 0);
    OpenedLevel opened(bakedLevel(place.surfaces, {{0, 0}}));
    render::VulkanDevice device(true);
    for (const WelkinVolumeFormat format : {WELKIN_VOLUME_RGBA16F, WELKIN_VOLUME_RGBA8}) {
      const DeviceVolume v(device, format);
      const WelkinSkySample sample = opened.relight(12.0);
      const float camera[3] = {30, 4, 40};
      const WelkinVolumeUpdate update = v.update(device, opened.level, sample, camera, 0);
      CHECK(update.cuts_left == 0);
      CHECK(update.bricks > 0);
      INFO(shape << ", format " << format << ", " << update.bricks << " bricks");
      const Points inside = innerSurfaces(place);
      const double open = brightest(lightOf(device, v, airOf({4, 1, 4}, {16, 2, 16}, 100)));
      CHECK(brightest(lightOf(device, v, inside)) == 0.0);
      CHECK(brightest(lightOf(device, v, inside, kVolumeUncutComp)) > 0.4 * open);
    }
    CHECK(device.messageCount() == 0);
  }
}

TEST_CASE("VolumeBricks, TheDeviceLightsAsTheTexelsOnTheCpu", "[vulkan]") {
  const LeakLevel place = leakLevel("room with a door", 3);
  OpenedLevel opened(bakedLevel(place.surfaces, {{0, 0}}));
  render::VulkanDevice device(true);
  {
    const DeviceVolume v(device, WELKIN_VOLUME_RGBA16F);
    const float camera[3] = {30, 4, 40};
    v.update(device, opened.level, opened.relight(12.0), camera, 0);
    const Points points = airOf({12, 0, 28}, {48, 9, 56}, 10000);
    const auto found = lightOf(device, v, points), plain = lightOf(device, v, points, kVolumeUncutComp);
    const double open = brightest(found);
    std::size_t off = 0, changed = 0;
    for (std::size_t i = 0; i < points.size() / 8; ++i) {
      float rgb[3];
      REQUIRE(welkin_volume_irradiance(v.volume, &points[8 * i], &points[8 * i + 4], rgb, nullptr) == WELKIN_OK);
      off += std::abs(double{rgb[1]} - double{found[4 * i + 1]}) > 1e-4 * open ? 1U : 0U;
      changed += std::abs(double{plain[4 * i + 1]} - double{found[4 * i + 1]}) > 1e-2 * open ? 1U : 0U;
    }
    CHECK(off <= 2);  // of 10,000: within the rounding of a float from a plane or a cell's face
    CHECK(changed > 100);
    // Two cells away from the room there is no brick.
    const Points far = airOf({4, 1, 4}, {16, 4, 24}, 1000);
    CHECK(lightOf(device, v, far) == lightOf(device, v, far, kVolumeUncutComp));
  }
  CHECK(device.messageCount() == 0);
}

TEST_CASE("VolumeBricks, TheyFollowCameraAndSectors", "[vulkan]") {
  LeakLevel place = leakLevel("hall 20 x 12 m", 1);
  move(place, Number3(-30.0, 0.0, 0.0));  // across the border at x = 0
  const RandomLevel baked = bakedLevel(place.surfaces, {{-1, 0}, {0, 0}});
  OpenedLevel opened(baked);
  render::VulkanDevice device(true);
  {
    const DeviceVolume v(device, WELKIN_VOLUME_RGBA16F);
    const Points inside = innerSurfaces(place);
    std::mt19937 random(2);
    std::array<float, 3> camera = {0, 4, 40};
    WelkinSkySample sample = opened.relight(12.0);
    const auto remove = [&](std::int32_t x) {
      WelkinSector* sector = nullptr;
      REQUIRE(welkin_level_remove(opened.level, x, 0, &sector) == WELKIN_OK);
      return sector;
    };
    for (uint32_t turn = 0; turn < 24; ++turn) {
      if (turn == 12) {  // the sector comes again, in another slot
        WelkinSector* sector = remove(-1);
        v.update(device, opened.level, sample, camera.data(), 0, 1);
        REQUIRE(welkin_level_add(opened.level, sector) == WELKIN_OK);
        sample = opened.relight(12.0);
      }
      if (turn % 4 == 3) sample = opened.relight(9.0 + turn / 4.0);
      camera[0] = std::clamp(camera[0] + std::uniform_real_distribution<float>(-9, 9)(random), -20.0F, 20.0F);
      camera[2] = std::clamp(camera[2] + std::uniform_real_distribution<float>(-9, 9)(random), 35.0F, 45.0F);
      v.update(device, opened.level, sample, camera.data(), 0, 1);
      INFO("turn " << turn);
      CHECK(brightest(lightOf(device, v, inside)) == 0.0);
    }
    while (v.update(device, opened.level, sample, camera.data(), 0).remaining > 0) continue;
    const DeviceVolume anew(device, WELKIN_VOLUME_RGBA16F);
    anew.update(device, opened.level, sample, camera.data(), 0);
    const Points about = airOf({-40, 0, 28}, {40, 9, 56}, 2000);
    const auto found = lightOf(device, v, about), wanted = lightOf(device, anew, about);
    double worst = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i)
      worst = std::max(worst, std::abs(double{found[i]} - double{wanted[i]}));
    // Bricks lie in other places of the texture. Its coordinates are floats, so a texel's share is off by 175 * 2^-24.
    CHECK(worst < 1e-4 * brightest(wanted));
  }
  CHECK(device.messageCount() == 0);
}

TEST_CASE("VolumeBricks, NoLightPassesFacesOfRooms", "[vulkan]") {
  for (const char* shape : {"hut 2.3 x 2.3 m", "corridor 0.8 m", "L of corridors 2 m"}) {
    LeakLevel place = leakLevel(shape, 2);
    for (const double by : {0.0, -30.0}) {  // then across the border at x = 0
      move(place, Number3(by, 0.0, 0.0));
      OpenedLevel opened(bakedLevel(place.surfaces, {{-1, 0}, {0, 0}}, 0, roomsOnly(place)));
      render::VulkanDevice device(true);
      {
        const DeviceVolume v(device, WELKIN_VOLUME_RGBA16F);
        const float camera[3] = {30.0F + static_cast<float>(by), 4, 40};
        const WelkinVolumeUpdate update = v.update(device, opened.level, opened.relight(12.0), camera, 0);
        CHECK(update.cuts_left == 0);
        INFO(shape << ", moved by " << by << ", " << update.bricks << " bricks");
        const Points inside = innerSurfaces(place);
        const double open = brightest(lightOf(device, v, airOf({4, 1, 4}, {16, 2, 16}, 100)));
        CHECK(brightest(lightOf(device, v, inside)) == 0.0);
        CHECK(brightest(lightOf(device, v, inside, kVolumeUncutComp)) > 0.4 * open);
      }
      CHECK(device.messageCount() == 0);
    }
  }
}

TEST_CASE("VolumeBricks, RoomsAreThoseOfTheQuery", "[vulkan]") {
  for (const char* shape : {"hut 3 x 3 m", "hut, turned by 17", "room with a door"})
    for (const placement::Walls walls : {placement::Walls::ignore, placement::Walls::cut}) {
      const LeakLevel place = leakLevel(shape, 3);
      placement::PlacementSettings settings = roomsOnly(place);
      settings.walls = walls;
      OpenedLevel opened(bakedLevel(place.surfaces, {{0, 0}}, 0, settings));
      render::VulkanDevice device(true);
      {
        const DeviceVolume v(device, WELKIN_VOLUME_RGBA16F);
        const float camera[3] = {30, 4, 40};
        v.update(device, opened.level, opened.relight(12.0), camera, 0);
        const geometry::Box& room = place.room[0];
        const Number3 middle = 0.5 * (room.low + room.high);
        const Points about = airOf(room.low - Number3(5.0, -0.1, 5.0), room.high + Number3(5.0), 4000);
        Points points = airOf(room.low, room.high, 2000);
        points.insert(points.end(), about.begin(), about.end());
        for (const double side : {-0.01, 0.01})  // off a face that is open or a wall, and along it
          for (int i = 0; i < 50; ++i)
            addPoint(points, Number3(room.high.x + side, middle.y, room.low.z + 0.02 * i), Number3(0.0, 1.0, 0.0));
        const auto found = lightOf(device, v, points);
        const double open = brightest(lightOf(device, v, airOf({4, 1, 4}, {16, 2, 16}, 100)));
        std::size_t count[2] = {};
        double mean[2] = {}, worst[2] = {}, most = 0.0;
        for (std::size_t i = 0; i < points.size() / 8; ++i) {
          const float* p = &points[8 * i];
          const auto isInside = [&](double way_m) {
            return geometry::contains(room, Number3(p[0], p[1], p[2]) + Number3(p[4], p[5], p[6]) * way_m);
          };
          const bool inside = isInside(0.0);
          // The device has the room of a place 0.25 m off the surface, the query that of 1 m.
          if (inside != isInside(1.0) || inside != isInside(0.25)) continue;
          float at[2][1][3] = {{{p[0], p[1], p[2]}}, {{p[4], p[5], p[6]}}}, query[1][3];
          REQUIRE(welkin_level_irradiance(opened.level, 1, at[0], at[1], query, nullptr) == WELKIN_OK);
          const double off = std::abs(double{query[0][1]} - double{found[4 * i + 1]}) / open;
          ++count[inside];
          mean[inside] += off;
          worst[inside] = std::max(worst[inside], off);
          if (inside) most = std::max(most, double{found[4 * i + 1]} / open);
        }
        INFO(shape << ", walls " << (walls == placement::Walls::cut ? "cut" : "ignored") << ": outside " << count[0]
                   << " points, mean " << mean[0] / static_cast<double>(count[0]) << ", worst " << worst[0]
                   << "; inside " << count[1] << " points, worst " << worst[1] << ", brightest " << most);
        REQUIRE(count[0] > 3000);
        REQUIRE(count[1] > 500);
        CHECK(worst[1] < 1e-3);  // the rounding of halves
        CHECK(mean[0] < 0.01 * static_cast<double>(count[0]));
        CHECK(worst[0] < 0.3);
      }
      CHECK(device.messageCount() == 0);
    }
}

TEST_CASE("VolumeBricks, WithoutRoomTheTexelsServe", "[vulkan]") {
  const LeakLevel place = leakLevel("hall 20 x 12 m", 0);
  OpenedLevel opened(bakedLevel(place.surfaces, {{0, 0}}));
  render::VulkanDevice device(true);
  for (const std::uint32_t bricks : {16U, WELKIN_VOLUME_NO_BRICKS}) {
    const DeviceVolume v(device, WELKIN_VOLUME_RGBA16F, {24, 8, 20}, bricks);
    const float camera[3] = {30, 4, 40};
    const WelkinVolumeUpdate update = v.update(device, opened.level, opened.relight(12.0), camera, 0);
    CHECK(update.cuts_left == (bricks == 16 ? 1 : 0));
    CHECK(update.bricks == 0);
    const Points inside = innerSurfaces(place);
    CHECK(lightOf(device, v, inside) == lightOf(device, v, inside, kVolumeUncutComp));
  }
  CHECK(device.messageCount() == 0);
}

}  // namespace welkin::tests
