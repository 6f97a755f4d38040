// SPDX-License-Identifier: Apache-2.0
// The discs of the sun and the moon: their energy, and the horizon that hides them.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "render/views.h"
#include "shared.h"
#include "test_sky.h"
#include "worst.h"

namespace welkin::tests {
namespace {

constexpr double kDiscRadius = 0.1;

render::Camera towards(const float direction[3], double fov_rad) {
  const f64::Number3 d{double{direction[0]}, double{direction[1]}, double{direction[2]}};
  return {std::atan2(d.x, -d.z), f64::elevationOf(d), fov_rad};
}

}  // namespace

TEST_CASE("VulkanDiscs, GiveTheirLightsNormalIrradiance", "[vulkan]") {
  constexpr uint32_t kSize = 200;
  constexpr double kFov = 0.4;
  // The edge is softened over the angle between pixels, here kFov / kSize = 2 % of the radius, evenly to both sides.
  // The area of a disc grows by a third of its square.
  constexpr double kEdgeTolerance = 2e-3;
  const auto bytes = testSkyFile({.disc_radius_rad = kDiscRadius});
  const Sky sky = openTestSky(bytes);
  render::VulkanDevice device(true);
  render::Views views(device, sky, WELKIN_VULKAN_ANALYTIC);
  views.setTime(11.0);
  const WelkinLight& sun = views.sample().sun;
  REQUIRE(sun.direction[1] > 0.5F);
  const render::Camera camera = towards(sun.direction, kFov);
  const render::FloatImage with = views.perspective(kSize, kSize, camera, true);
  const render::FloatImage without = views.perspective(kSize, kSize, camera, false);
  const double pixel = 2.0 * std::tan(0.5 * kFov) / kSize;
  double irradiance[3] = {};
  for (uint32_t y = 0; y < kSize; ++y)
    for (uint32_t x = 0; x < kSize; ++x) {
      const double u = (x + 0.5 - 0.5 * kSize) * pixel;
      const double v = (y + 0.5 - 0.5 * kSize) * pixel;
      const double cosine = 1.0 / std::sqrt(1.0 + u * u + v * v);
      for (int c = 0; c < 3; ++c)
        irradiance[c] +=
            (double{with.pixel(x, y)[c]} - double{without.pixel(x, y)[c]}) * pixel * pixel * std::pow(cosine, 4.0);
    }
  for (int c = 0; c < 3; ++c) CHECK(irradiance[c] == Approx(double{sun.normal_irradiance[c]}).epsilon(kEdgeTolerance));
  CHECK(device.messageCount() == 0);
}

TEST_CASE("VulkanDiscs, EndAtTheHorizon", "[vulkan]") {
  constexpr uint32_t kSize = 64;
  const auto bytes = testSkyFile({.disc_radius_rad = kDiscRadius});
  const Sky sky = openTestSky(bytes);
  render::VulkanDevice device(true);
  render::Views views(device, sky, WELKIN_VULKAN_ANALYTIC);
  views.setTime(2.0 + 12.0 * 0.7 / 1.3);  // the moon's elevation goes from 0.7 at 2 h to -0.6 at 14 h
  const WelkinLight& moon = views.sample().moon;
  REQUIRE(std::abs(moon.direction[1]) < 1e-3F);
  render::Camera camera = towards(moon.direction, 0.5);
  camera.pitch_rad = 0.0;
  const render::FloatImage with = views.perspective(kSize, kSize, camera, true);
  const render::FloatImage without = views.perspective(kSize, kSize, camera, false);
  double above = 0.0;
  double below = 0.0;
  for (uint32_t y = 0; y < kSize; ++y)
    for (uint32_t x = 0; x < kSize; ++x)
      (y < kSize / 2 ? above : below) += double{with.pixel(x, y)[2]} - double{without.pixel(x, y)[2]};
  CHECK(above > 0.0);
  CHECK(below == 0.0);
  CHECK(device.messageCount() == 0);
}

TEST_CASE("VulkanDiscs, EqualTheRuntimePerPixel", "[vulkan]") {
  constexpr uint32_t kSize = 96;
  constexpr double kFov = 0.3;
  const auto bytes = testSkyFile({.disc_radius_rad = kDiscRadius});
  const Sky sky = openTestSky(bytes);
  render::VulkanDevice device(true);
  render::Views views(device, sky, WELKIN_VULKAN_ANALYTIC);
  // The edge is a ramp over a pixel, so an error of the angle counts by its share of a pixel.
  const double tolerance = shaderTolerance(device) * (1.0 + kDiscRadius * kSize / kFov);
  for (const double time_h : {8.0, 11.0, 20.0, 23.0})
    for (const bool moon : {false, true}) {
      views.setTime(time_h);
      const WelkinLight& light = moon ? views.sample().moon : views.sample().sun;
      if (light.direction[1] < 0.2F) continue;
      const render::Camera camera = towards(light.direction, kFov);
      const auto with = views.perspective(kSize, kSize, camera, true);
      const auto without = views.perspective(kSize, kSize, camera, false);
      const f64::Number3 forward = f64::directionOf(camera.yaw_rad, camera.pitch_rad);
      const f64::Number3 right = f64::directionOf(camera.yaw_rad + f64::kHalfPi, 0.0);
      const f64::Number3 up = cross(right, forward);
      const double step = 2.0 * std::tan(0.5 * kFov) / kSize;
      const auto ray = [&](double x, double y) {
        const auto d = forward + right * ((x + 0.5 - 0.5 * kSize) * step) - up * ((y + 0.5 - 0.5 * kSize) * step);
        return d / std::sqrt(dot(d, d));
      };
      Worst worst;
      double brightest = 0.0;
      for (uint32_t y = 0; y < kSize; ++y)
        for (uint32_t x = 0; x < kSize; ++x) {
          const auto d = ray(x, y);
          // The shader's pixel is the derivative over its 2 x 2 quad.
          const double qx = x & ~1U, qy = y & ~1U;
          const auto dx = ray(qx + 1, y) - ray(qx, y), dy = ray(x, qy + 1) - ray(x, qy);
          const double pixel = std::max(std::sqrt(dot(dx, dx)), std::sqrt(dot(dy, dy)));
          const float direction[3] = {float(d.x), float(d.y), float(d.z)};
          float expected[3];
          REQUIRE(welkin_disc_radiance(&views.sample(), direction, float(pixel), expected) == WELKIN_OK);
          const double scale = double{light.normal_irradiance[1]} / (f64::kPi * std::pow(std::sin(kDiscRadius), 2.0));
          brightest = std::max(brightest, double{expected[1]} / scale);
          worst.compare(double{with.pixel(x, y)[1]} - double{without.pixel(x, y)[1]}, double{expected[1]}, scale,
                        [&] { return "pixel " + std::to_string(x) + "," + std::to_string(y); });
        }
      INFO("hour " << time_h << (moon ? " moon" : " sun") << " worst " << worst.error << " at " << worst.where);
      CHECK(worst.error < tolerance);
      CHECK(brightest > 0.0);
    }
  CHECK(device.messageCount() == 0);
}

}  // namespace welkin::tests
