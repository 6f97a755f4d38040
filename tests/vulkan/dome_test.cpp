// SPDX-License-Identifier: Apache-2.0
// The dome pass against the runtime's own evaluation in double.
#include <catch2/catch.hpp>

#include "render/views.h"
#include "shared.h"
#include "sky/cubemap/cubemap_filter.h"
#include "test_sky.h"
#include "worst.h"

namespace welkin::tests {
namespace {

using f64::Number3;
using render::FloatImage;

constexpr double kHours[] = {0.0, 0.3, 5.9, 6.6, 12.0, 17.35, 19.0, 23.99};

/// Direction of a pixel of a square fisheye picture by its definition; false outside the circle.
bool fisheyeDirection(uint32_t x, uint32_t y, uint32_t size, Number3& direction) {
  const double left = 1.0 - 2.0 * (x + 0.5) / size;  // east to the left
  const double up = 1.0 - 2.0 * (y + 0.5) / size;
  const double radius = std::hypot(left, up);
  direction = f64::directionOf(std::atan2(left, up), f64::kHalfPi * (1.0 - radius));
  return radius < 1.0;
}

std::array<float, 3> runtimeRadiance(const Sky& sky, const WelkinSkySample& sample, Number3 d) {
  const float direction[3] = {static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z)};
  std::array<float, 3> radiance{};
  REQUIRE(welkin_dome_radiance(sky.get(), &sample, direction, radiance.data()) == WELKIN_OK);
  return radiance;
}

void compare(Worst& worst, const FloatImage& image, uint32_t x, uint32_t y, const std::array<float, 3>& expected,
             double time_h) {
  const double scale = std::max({double{expected[0]}, double{expected[1]}, double{expected[2]}, 1e-30});
  for (std::size_t i = 0; i < 3; ++i)
    worst.compare(double{image.pixel(x, y)[i]}, double{expected[i]}, scale, [&] {
      return "pixel " + std::to_string(x) + "," + std::to_string(y) + " channel " + std::to_string(i) + " hour " +
             std::to_string(time_h);
    });
}

}  // namespace

TEST_CASE("VulkanDome, AnalyticFisheyeEqualsRuntime", "[vulkan]") {
  constexpr uint32_t kSize = 96;
  for (const bool to_sun : {true, false}) {
    const auto bytes = testSkyFile({.normalise_to_sun = to_sun});
    const Sky sky = openTestSky(bytes);
    render::VulkanDevice device(true);
    Worst worst;
    {
      render::Views views(device, sky, WELKIN_VULKAN_ANALYTIC);
      for (const double time_h : kHours) {
        views.setTime(time_h);
        const FloatImage image = views.dome(kSize, kSize, false);
        for (uint32_t y = 0; y < kSize; ++y)
          for (uint32_t x = 0; x < kSize; ++x) {
            Number3 direction;
            const bool inside = fisheyeDirection(x, y, kSize, direction);
            compare(worst, image, x, y,
                    inside ? runtimeRadiance(sky, views.sample(), direction) : std::array<float, 3>{}, time_h);
          }
      }
    }
    WARN("normalise to " << (to_sun ? "sun" : "zenith") << ": worst " << worst.error << " at " << worst.where);
    CHECK(worst.error < shaderTolerance(device));
    CHECK(device.messageCount() == 0);
  }
}

TEST_CASE("VulkanDome, PerspectiveEqualsRuntime", "[vulkan]") {
  constexpr uint32_t kWidth = 90;
  constexpr uint32_t kHeight = 60;
  const auto bytes = testSkyFile({});
  const Sky sky = openTestSky(bytes);
  render::VulkanDevice device(true);
  Worst worst;
  {
    render::Views views(device, sky, WELKIN_VULKAN_ANALYTIC);
    views.setTime(8.2);
    const render::Camera camera{0.8, 0.25, 1.2};
    const FloatImage image = views.perspective(kWidth, kHeight, camera, false);
    // The ray is rotated from a camera that looks north: pitch about east, then yaw about down.
    const double half = std::tan(0.5 * camera.fov_rad);
    for (uint32_t y = 0; y < kHeight; ++y)
      for (uint32_t x = 0; x < kWidth; ++x) {
        const double right = (2.0 * (x + 0.5) / kWidth - 1.0) * half * kWidth / kHeight;
        const double up = (1.0 - 2.0 * (y + 0.5) / kHeight) * half;
        const double c = std::cos(camera.pitch_rad);
        const double s = std::sin(camera.pitch_rad);
        const double north = c - up * s;
        const double length = std::sqrt(right * right + up * up + 1.0);
        const double cy = std::cos(camera.yaw_rad);
        const double sy = std::sin(camera.yaw_rad);
        const Number3 direction = Number3(right * cy + north * sy, s + up * c, right * sy - north * cy) / length;
        if (std::abs(direction.y) < 1e-6) continue;  // rounding may put it on either side of the horizon
        compare(worst, image, x, y, runtimeRadiance(sky, views.sample(), direction), 8.2);
      }
  }
  WARN("worst " << worst.error << " at " << worst.where);
  CHECK(worst.count > 3 * 5000);
  CHECK(worst.error < shaderTolerance(device));
  CHECK(device.messageCount() == 0);
}

TEST_CASE("VulkanDome, FisheyeLooksUpWithNorthUpAndEastLeft", "[vulkan]") {
  constexpr uint32_t kSize = 64;
  const auto bytes = testSkyFile({.disc_radius_rad = 0.1});
  const Sky sky = openTestSky(bytes);
  render::VulkanDevice device(true);
  render::Views views(device, sky, WELKIN_VULKAN_ANALYTIC);
  views.setTime(9.0);  // the sun stands in the north-east, turned by the path's north offset
  const float* sun = views.sample().sun.direction;
  REQUIRE(sun[0] > 0.2F);
  const FloatImage with = views.dome(kSize, kSize, true);
  const FloatImage without = views.dome(kSize, kSize, false);
  double x_mean = 0.0;
  double y_mean = 0.0;
  double weight = 0.0;
  for (uint32_t y = 0; y < kSize; ++y)
    for (uint32_t x = 0; x < kSize; ++x) {
      const double added = double{with.pixel(x, y)[0]} - double{without.pixel(x, y)[0]};
      CHECK(added >= 0.0);
      x_mean += added * (x + 0.5);
      y_mean += added * (y + 0.5);
      weight += added;
    }
  REQUIRE(weight > 0.0);
  const double radius = std::acos(double{sun[1]}) / f64::kHalfPi;
  const double horizontal = std::hypot(double{sun[0]}, double{sun[2]});
  CHECK(x_mean / weight == Approx((1.0 - radius * double{sun[0]} / horizontal) * kSize / 2).margin(0.6));
  CHECK(y_mean / weight == Approx((1.0 + radius * double{sun[2]} / horizontal) * kSize / 2).margin(0.6));
  CHECK(device.messageCount() == 0);
}

namespace {

Number3 filtered(const WelkinCubemap& cube, const Number3& d) {
  const auto value = cubemap::filterTexels(static_cast<const unsigned char*>(cube.texels),
                                           static_cast<format::CubemapFormat>(cube.format),
                                           cubemap::footprintOf(static_cast<int>(cube.size), {d.x, d.y, d.z}));
  return {value.x, value.y, value.z};
}

}  // namespace

TEST_CASE("VulkanDome, CubemapsAreFilteredAndBlended", "[vulkan]") {
  constexpr uint32_t kSize = 64;
  const auto format =
      GENERATE(format::CubemapFormat::rgba16f, format::CubemapFormat::rgb9e5, format::CubemapFormat::b10g11r11);
  const auto bytes = testSkyFile({.cubemap_format = format});
  const Sky sky = openTestSky(bytes);
  render::VulkanDevice device(true);
  // A filtering unit may round its two weights to 8 bits: 2^-9 of the texel difference (here below 2) for each.
  const double tolerance = device.properties().deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU ? 2e-5 : 2.0 * 2.0 / 512.0;
  Worst worst;
  {
    render::Views views(device, sky, WELKIN_VULKAN_CUBEMAP);
    const auto compareAt = [&](const FloatImage& image, uint32_t x, uint32_t y, Number3 direction) {
      const WelkinSkySample& sample = views.sample();
      WelkinCubemap first;
      WelkinCubemap second;
      REQUIRE(welkin_sky_cubemap(sky.get(), sample.cubemap[0], &first) == WELKIN_OK);
      REQUIRE(welkin_sky_cubemap(sky.get(), sample.cubemap[1], &second) == WELKIN_OK);
      const Number3 expected =
          mix(filtered(first, direction), filtered(second, direction), double{sample.cubemap_weight});
      for (int i = 0; i < 3; ++i)
        worst.compare(double{image.pixel(x, y)[i]}, expected[i], 1.0, [&] {
          return "pixel " + std::to_string(x) + "," + std::to_string(y) + " hour " + std::to_string(sample.time_h);
        });
    };
    for (const double time_h : {3.0, 7.0, 11.0, 12.5, 19.9, 22.0, 1.0}) {
      views.setTime(time_h);
      const FloatImage dome = views.dome(kSize, kSize, false);
      const FloatImage below = views.perspective(kSize, kSize, {time_h, -1.2, 1.7}, false);
      const auto matrix = render::inverseViewProjection({time_h, -1.2, 1.7}, 1.0);
      for (uint32_t y = 0; y < kSize; ++y)
        for (uint32_t x = 0; x < kSize; ++x) {
          Number3 direction;
          if (fisheyeDirection(x, y, kSize, direction)) compareAt(dome, x, y, direction);
          const double ndc[2] = {2.0 * (x + 0.5) / kSize - 1.0, 2.0 * (y + 0.5) / kSize - 1.0};
          for (int i = 0; i < 3; ++i)
            direction[i] = ndc[0] * double{matrix[static_cast<std::size_t>(i)]} +
                           ndc[1] * double{matrix[static_cast<std::size_t>(4 + i)]} +
                           double{matrix[static_cast<std::size_t>(12 + i)]};
          compareAt(below, x, y, direction);
        }
    }
  }
  WARN("worst " << worst.error << " at " << worst.where << " of " << worst.count);
  CHECK(worst.count > 3 * 7 * kSize * kSize);
  CHECK(worst.error < tolerance);
  CHECK(device.messageCount() == 0);
}

}  // namespace welkin::tests
