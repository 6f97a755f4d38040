// SPDX-License-Identifier: Apache-2.0
// Compares the ambient light of shaders with the runtime's: in a compute shader, and on the spheres of a picture.
#include <catch2/catch.hpp>
#include <cstdint>

#include "compute.h"
#include "render/views.h"
#include "shared.h"
#include "spirv/kAmbientComp.h"
#include "test_sky.h"
#include "worst.h"

namespace welkin::tests {
namespace {

using f64::Number3;

/// Sum of at most 25 products in float. Each has an error below 4 units in the last place of the largest: 25 x 4 x
/// 2^-24. The bound is relative to the mean irradiance, which is no smaller than the largest term here.
constexpr double kSumTolerance = 6e-6;

/// Points of a golden-angle spiral: evenly spread, with no two symmetric.
std::vector<Number3> spiral(std::size_t count) {
  std::vector<Number3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double y = 1.0 - 2.0 * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const double r = std::sqrt(1.0 - y * y);
    const double angle = 2.39996322972865332 * static_cast<double>(i);
    points.push_back({r * std::cos(angle), y, r * std::sin(angle)});
  }
  return points;
}

std::array<float, 3> irradianceOf(const WelkinSkySample& sample, Number3 n) {
  const float normal[3] = {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
  std::array<float, 3> e{};
  REQUIRE(welkin_sample_irradiance(&sample, normal, e.data()) == WELKIN_OK);
  return e;
}

/// The mean irradiance in closed form: pi c0 Y00.
double flatIrradiance(const WelkinSkySample& sample, int channel) {
  return 0.5 * std::sqrt(f64::kPi) * double{sample.ambient_sh[0][channel]};
}

}  // namespace

TEST_CASE("VulkanAmbient, EqualsRuntime", "[vulkan]") {
  const auto bytes = testSkyFile({});
  const Sky sky = openTestSky(bytes);
  render::VulkanDevice device(true);
  const std::vector<Number3> normals = spiral(642);
  std::vector<float> input;
  for (const Number3& n : normals)
    input.insert(input.end(), {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z), 0.0F});
  Worst worst;
  {
    render::Views views(device, sky, WELKIN_VULKAN_ANALYTIC);
    for (const double time_h : {0.5, 12.2, 21.0}) {
      views.setTime(time_h);
      const auto results = runCompute(device, kAmbientComp, input, 16 * normals.size(), 16,
                                      welkin_vulkan_descriptor_set_layout(views.runtime()),
                                      welkin_vulkan_descriptor_set(views.runtime(), 0));
      for (std::size_t i = 0; i < normals.size(); ++i) {
        const auto expected = irradianceOf(views.sample(), normals[i]);
        for (int c = 0; c < 3; ++c) {
          const double flat = flatIrradiance(views.sample(), c);
          const auto at = [&] { return "normal " + std::to_string(i) + " hour " + std::to_string(time_h); };
          const float* r = results.data() + 16 * i + c;
          const double e = double{expected[static_cast<std::size_t>(c)]};
          worst.compare(double{r[0]}, e, flat, at);
          worst.compare(double{r[4]}, e / f64::kPi, flat / f64::kPi, at);
          worst.compare(double{r[8]}, flat, flat, at);
          worst.compare(double{r[12]}, flat / f64::kPi, flat / f64::kPi, at);
        }
      }
    }
  }
  WARN("worst " << worst.error << " at " << worst.where);
  CHECK(worst.error < kSumTolerance);
  CHECK(device.messageCount() == 0);
}

TEST_CASE("VulkanSpheres, RadianceIsAlbedoTimesIrradianceOverPi", "[vulkan]") {
  constexpr uint32_t kHeight = 60;
  constexpr uint32_t kCell = 60;  // pixels from one sphere to the next
  constexpr uint32_t kWidth = kCell * WELKIN_SPHERE_COUNT;
  const auto bytes = testSkyFile({});
  const Sky sky = openTestSky(bytes);
  render::VulkanDevice device(true);
  render::Views views(device, sky, WELKIN_VULKAN_ANALYTIC);
  views.setTime(15.0);
  const render::Camera camera{0.7, 0.0, 0.9};
  const Number3 forward = f64::directionOf(camera.yaw_rad, 0.0);
  const Number3 right = f64::directionOf(camera.yaw_rad + f64::kHalfPi, 0.0);
  const double radius = WELKIN_SPHERE_RADIUS * kCell;  // pixels
  for (const auto light : {render::SkyLight::flat, render::SkyLight::sh, render::SkyLight::both}) {
    const render::FloatImage image = views.spheres(kWidth, kHeight, camera, light);
    for (uint32_t sphere = 0; sphere < WELKIN_SPHERE_COUNT; ++sphere) {
      const bool left_half = sphere < WELKIN_SPHERE_COUNT / 2;
      const double albedo = WELKIN_SPHERE_ALBEDO;
      const bool flat = light == render::SkyLight::flat || (light == render::SkyLight::both && left_half);
      for (const auto& [dx, dy] : {std::pair{0, 0}, std::pair{15, -10}, std::pair{-8, 17}}) {
        const uint32_t x = static_cast<uint32_t>(static_cast<int>(sphere * kCell + kCell / 2) + dx);
        const uint32_t y = static_cast<uint32_t>(static_cast<int>(kHeight / 2) + dy);
        const double a = (dx + 0.5) / radius;
        const double b = -(dy + 0.5) / radius;
        const Number3 normal = right * a + Number3(0.0, b, 0.0) - forward * std::sqrt(1.0 - a * a - b * b);
        const auto e = irradianceOf(views.sample(), normal);
        for (int c = 0; c < 3; ++c) {
          const double expected =
              albedo * (flat ? flatIrradiance(views.sample(), c) : double{e[static_cast<std::size_t>(c)]}) / f64::kPi;
          CHECK(double{image.pixel(x, y)[c]} == Approx(expected).epsilon(1e-4));  // the normal is interpolated in float
        }
      }
    }
  }
  CHECK(device.messageCount() == 0);
}

}  // namespace welkin::tests
