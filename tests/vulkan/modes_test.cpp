// SPDX-License-Identifier: Apache-2.0
// The light of a file's modes in a shader against welkin_sky_irradiance, in a compute shader and on the spheres of a
// picture. Also the shader's result without modes.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "compute.h"
#include "mode_normals.h"
#include "object.h"
#include "render/views.h"
#include "shared.h"
#include "spirv/kFourModesComp.h"
#include "spirv/kModesComp.h"
#ifdef WELKIN_MODES_HLSL
#include "spirv/kModesHlsl12.h"
#include "spirv/kModesHlsl4.h"
#include "spirv/kModesHlsl8.h"
#endif
#include "test_sky.h"
#include "worst.h"

namespace welkin::tests {
namespace {

using f64::Number3;
/// Tolerance relative to the largest irradiance of an instant. The map's coordinates have an error of 3 units of 2^-24.
/// Neighbours in the map differ by as much as the modes are large. The map has 8 columns and 5 rows between its outer
/// centres: 13 x 3 units. The sum of 16 products adds 16 units.
constexpr double kSoftware = 56.0 / 16777216.0;

/// Adds Vulkan's bound for a filter: its weights are rounded to subTexelPrecisionBits bits, along both axes.
double tolerance(const render::VulkanDevice& device) {
  const auto& properties = device.properties();
  if (properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU) return kSoftware;
  return kSoftware + std::ldexp(2.0, -static_cast<int>(properties.limits.subTexelPrecisionBits));
}

std::vector<float> shade(render::VulkanDevice& device, std::span<const uint32_t> shader, const WelkinVulkanSky* object,
                         const std::vector<Vector>& directions) {
  std::vector<float> input;
  for (const Vector& n : directions) input.insert(input.end(), {n[0], n[1], n[2], 0.0F});
  return runCompute(device, shader, input, 8 * directions.size(), 8, welkin_vulkan_descriptor_set_layout(object),
                    welkin_vulkan_descriptor_set(object, 0));
}

struct Comparison {
  Worst worst;
  float least = std::numeric_limits<float>::max();  ///< least irradiance: it must be above 0, as clamping hides errors
};

/// Compares the shader's light at three hours with the runtime's.
Comparison compare(render::VulkanDevice& device, const Sky& sky, std::span<const uint32_t> shader) {
  const std::vector<Vector> directions = modeNormals();
  const SkyObject object(device, sky, createInfo(device, 1));
  Comparison result;
  WelkinSkySample sample{};
  for (const double time_h : {0.5, 12.2, 21.0}) {
    REQUIRE(sky.sample(time_h, sample));
    REQUIRE(welkin_vulkan_update(object.get(), 0, &sample) == WELKIN_OK);
    const auto results = shade(device, shader, object.get(), directions);
    std::vector<Vector> expected;
    float largest = 0.0F;
    for (const Vector& n : directions) {
      expected.push_back(expectedOf(sky, sample, n));
      for (const float e : expected.back()) largest = std::max(largest, e);
      for (const float e : expected.back()) result.least = std::min(result.least, e / largest);
    }
    for (std::size_t i = 0; i < directions.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) {
        const auto at = [&] { return "normal " + std::to_string(i) + " hour " + std::to_string(time_h); };
        const double e = double{expected[i][c]};
        result.worst.compare(double{results[8 * i + c]}, e, double{largest}, at);
        result.worst.compare(double{results[8 * i + 4 + c]}, e / f64::kPi, double{largest} / f64::kPi, at);
      }
  }
  return result;
}

}  // namespace

TEST_CASE("VulkanModes, EqualRuntime", "[vulkan]") {
  render::VulkanDevice device(true);
  for (const uint8_t count : {1, 2, 3, 4, 5, 6, 7, 8, 9, 12}) {
    CAPTURE(int{count});
    const auto bytes = testSkyFile({.mode_count = count});
    const Sky sky = openTestSky(bytes);
    REQUIRE(sky.info().mode_count == count);
    const Comparison all = compare(device, sky, kModesComp);
    CAPTURE(all.worst.where, all.least);
    CHECK(all.worst.error < tolerance(device));
    CHECK(all.least > 0.0F);
    if (count == 12) WARN("worst " << all.worst.error << " at " << all.worst.where);
    const Comparison four = compare(device, sky, kFourModesComp);
    if (count <= 4)
      CHECK(four.worst.error < tolerance(device));
    else
      CHECK(four.worst.error > 0.01);  // the second layer is not read
  }
  CHECK(device.messageCount() == 0);
}

TEST_CASE("VulkanModes, InHlslEqualGlsl", "[vulkan]") {
#ifdef WELKIN_MODES_HLSL
  render::VulkanDevice device(true);
  const std::pair<std::span<const uint32_t>, uint8_t> shaders[] = {
      {kModesHlsl4, 4}, {kModesHlsl8, 8}, {kModesHlsl12, 12}};
  double most = 0.0;
  for (const uint8_t count : {1, 4, 5, 8, 9, 12})
    for (const auto& [shader, holds] : shaders) {
      CAPTURE(int{count}, int{holds});
      const auto bytes = testSkyFile({.mode_count = count});
      const Sky sky = openTestSky(bytes);
      const Comparison hlsl = compare(device, sky, shader);
      CAPTURE(hlsl.worst.where);
      if (count > holds) {
        CHECK(hlsl.worst.error > 0.01);  // a layer is not read
        continue;
      }
      CHECK(hlsl.worst.error < tolerance(device));
      const std::vector<Vector> directions = modeNormals();
      const SkyObject object(device, sky, createInfo(device, 1));
      WelkinSkySample sample{};
      REQUIRE(sky.sample(12.2, sample));
      REQUIRE(welkin_vulkan_update(object.get(), 0, &sample) == WELKIN_OK);
      const auto expected = shade(device, kModesComp, object.get(), directions);
      const auto results = shade(device, shader, object.get(), directions);
      const double largest = double{*std::max_element(expected.begin(), expected.end())};
      REQUIRE(results.size() == expected.size());
      for (std::size_t i = 0; i < results.size(); ++i)
        most = std::max(most, std::abs(double{results[i]} - double{expected[i]}) / largest);
    }
  WARN("HLSL differs from GLSL by " << most << " of the largest irradiance");
  CHECK(most < kSoftware);
  CHECK(device.messageCount() == 0);
#else
  WARN("skipped: the build has no spirv-cross, so there is no HLSL");
#endif
}

TEST_CASE("VulkanModes, DenormalYIsOnEitherSideOfTheHorizon", "[vulkan]") {
  const auto bytes = testSkyFile({.mode_count = 5});
  const Sky sky = openTestSky(bytes);
  render::VulkanDevice device(true);
  const SkyObject object(device, sky, createInfo(device, 1));
  WelkinSkySample sample{};
  REQUIRE(sky.sample(12.2, sample));
  REQUIRE(welkin_vulkan_update(object.get(), 0, &sample) == WELKIN_OK);
  const float least = std::numeric_limits<float>::denorm_min();
  const auto results = shade(device, kModesComp, object.get(), {{0.6F, -least, 0.8F}, {0.6F, least, 0.8F}});
  const Vector sides[2] = {expectedOf(sky, sample, {0.6F, -1e-30F, 0.8F}), expectedOf(sky, sample, {0.6F, 0.0F, 0.8F})};
  for (std::size_t c = 0; c < 3; ++c) {
    const double below = std::abs(double{results[c]} - double{sides[0][c]});
    const double above = std::abs(double{results[c]} - double{sides[1][c]});
    CHECK(std::min(below, above) < tolerance(device) * double{sides[1][c]} * 2.0);
    CHECK(double{results[8 + c]} == Approx(double{sides[1][c]}).epsilon(2.0 * tolerance(device)));
  }
  CHECK(device.messageCount() == 0);
}

TEST_CASE("VulkanModes, ABlendOfAFamilyIsTheSumOfItsSkies", "[vulkan]") {
  const std::vector<Vector> directions = modeNormals();
  render::VulkanDevice device(true);
  const auto clear_bytes = testSkyFile({.mode_count = 5}), storm_bytes = testSkyFile({.mode_count = 5, .day = 3});
  const Sky clear = openTestSky(clear_bytes), storm = openTestSky(storm_bytes);
  {
    const SkyObject object(device, clear, createInfo(device, 1));
    WelkinSkySample first{}, second{}, blended{};
    REQUIRE(clear.sample(12.2, first));
    REQUIRE(storm.sample(12.2, second));
    REQUIRE(first.mode_family == second.mode_family);
    for (const float weight : {0.0F, 0.3F, 1.0F}) {
      REQUIRE(welkin_sample_blend(&first, &second, weight, &blended) == WELKIN_OK);
      REQUIRE(blended.mode_count == 5);
      REQUIRE(welkin_vulkan_update(object.get(), 0, &first) == WELKIN_OK);
      REQUIRE(welkin_vulkan_update_ambient(object.get(), 0, &blended) == WELKIN_OK);
      const auto results = shade(device, kModesComp, object.get(), directions);
      double worst = 0.0, largest = 0.0, between = 0.0;
      for (std::size_t i = 0; i < directions.size(); ++i) {
        const Vector a = expectedOf(clear, first, directions[i]), b = expectedOf(storm, second, directions[i]);
        for (std::size_t c = 0; c < 3; ++c) {
          const double e = (1.0 - double{weight}) * double{a[c]} + double{weight} * double{b[c]};
          largest = std::max(largest, e);
          worst = std::max(worst, std::abs(double{results[8 * i + c]} - e));
          between = std::max(between, std::abs(double{a[c]} - double{b[c]}));
        }
      }
      INFO("weight " << weight);
      CHECK(worst < 2.0 * tolerance(device) * largest);  // the two skies' own floats, too
      CHECK(between > 0.1 * largest);
    }
  }
  CHECK(device.messageCount() == 0);
}

TEST_CASE("VulkanModes, WithoutModesTheFirstTwoBandsAreShown", "[vulkan]") {
  const std::vector<Vector> directions = modeNormals();
  render::VulkanDevice device(true);
  const auto with_bytes = testSkyFile({.mode_count = 5});
  const auto without_bytes = testSkyFile({});
  const Sky with = openTestSky(with_bytes);
  const Sky without = openTestSky(without_bytes);
  WelkinSkySample first{}, second{}, blended{};
  REQUIRE(with.sample(12.2, first));
  REQUIRE(without.sample(12.2, second));
  REQUIRE(welkin_sample_blend(&first, &second, 0.7F, &blended) == WELKIN_OK);
  const auto check = [&](const WelkinVulkanSky* object, const WelkinSkySample& shown) {
    const auto results = shade(device, kModesComp, object, directions);
    WelkinSkySample two_bands = shown;
    two_bands.coefficient_count = 4;
    Worst worst;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      float e[3];
      REQUIRE(welkin_sample_irradiance(&two_bands, directions[i].data(), e) == WELKIN_OK);
      for (std::size_t c = 0; c < 3; ++c)
        worst.compare(double{results[8 * i + c]}, double{e[c]}, double{shown.ambient_sh[0][c]},
                      [&] { return "normal " + std::to_string(i); });
    }
    CAPTURE(worst.where);
    CHECK(worst.error < kSoftware);
  };
  {
    const SkyObject object(device, without, createInfo(device, 1));
    REQUIRE(welkin_vulkan_update(object.get(), 0, &second) == WELKIN_OK);
    check(object.get(), second);
    CHECK(welkin_vulkan_update(object.get(), 0, &first) == WELKIN_ERROR_ARGUMENT);  // modes of another file
    CHECK(welkin_vulkan_update_ambient(object.get(), 0, &first) == WELKIN_ERROR_ARGUMENT);
  }
  {
    const SkyObject object(device, with, createInfo(device, 1));
    REQUIRE(welkin_vulkan_update(object.get(), 0, &first) == WELKIN_OK);
    REQUIRE(welkin_vulkan_update_ambient(object.get(), 0, &blended) == WELKIN_OK);
    check(object.get(), blended);
    REQUIRE(welkin_vulkan_update_ambient(object.get(), 0, &first) == WELKIN_OK);  // and back to the modes
    const auto results = shade(device, kModesComp, object.get(), directions);
    for (std::size_t i = 0; i < directions.size(); ++i)
      CHECK(double{results[8 * i]} == Approx(double{expectedOf(with, first, directions[i])[0]}).epsilon(0.01));
  }
  CHECK(device.messageCount() == 0);
}

TEST_CASE("VulkanModes, MapIsAnArrayOfALayerForEveryFour", "[vulkan]") {
  constexpr uint32_t kMap = 3;  // after the gradients and the stars
  for (const uint8_t count : {0, 4, 5, 8, 9, 12}) {
    const auto bytes = testSkyFile({.mode_count = count});
    const Sky sky = openTestSky(bytes);
    uint32_t images = 0;
    REQUIRE(welkin_vulkan_image_infos(sky.get(), &images, nullptr) == WELKIN_OK);
    std::vector<VkImageCreateInfo> infos(images);
    REQUIRE(welkin_vulkan_image_infos(sky.get(), &images, infos.data()) == WELKIN_OK);
    CHECK(infos[kMap].format == VK_FORMAT_R16G16B16A16_SFLOAT);
    CHECK(infos[kMap].arrayLayers == (count > 8 ? 3 : count > 4 ? 2 : 1));
    CHECK(infos[kMap].extent.width == (count > 0 ? kModeColumns : 1));
    CHECK(infos[kMap].extent.height == (count > 0 ? kModeRows : 1));
    CHECK(infos[kMap].mipLevels == 1);
  }
}

TEST_CASE("VulkanModes, SpheresShowWhatTheRuntimeSays", "[vulkan]") {
  constexpr uint32_t kHeight = 60;
  constexpr uint32_t kCell = 60;  // pixels from one sphere to the next
  const auto bytes = testSkyFile({.mode_count = 6});
  const Sky sky = openTestSky(bytes);
  render::VulkanDevice device(true);
  render::Views views(device, sky, WELKIN_VULKAN_ANALYTIC);
  views.setTime(15.0);
  const render::Camera camera{0.7, 0.0, 0.9};
  const Number3 forward = f64::directionOf(camera.yaw_rad, 0.0);
  const Number3 right = f64::directionOf(camera.yaw_rad + f64::kHalfPi, 0.0);
  const double radius = WELKIN_SPHERE_RADIUS * kCell;  // pixels
  const auto image = views.spheres(kCell * WELKIN_SPHERE_COUNT, kHeight, camera, render::SkyLight::sh);
  double difference = 0.0;
  for (uint32_t sphere = 0; sphere < WELKIN_SPHERE_COUNT; ++sphere)
    for (const auto& [dx, dy] : {std::pair{0, 0}, std::pair{15, -10}, std::pair{-8, 17}, std::pair{9, -19}}) {
      const uint32_t x = static_cast<uint32_t>(static_cast<int>(sphere * kCell + kCell / 2) + dx);
      const uint32_t y = static_cast<uint32_t>(static_cast<int>(kHeight / 2) + dy);
      const double a = (dx + 0.5) / radius;
      const double b = -(dy + 0.5) / radius;
      const Number3 n = right * a + Number3(0.0, b, 0.0) - forward * std::sqrt(1.0 - a * a - b * b);
      const Vector normal{static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
      const Vector e = expectedOf(sky, views.sample(), normal);
      Vector of_coefficients{};
      REQUIRE(welkin_sample_irradiance(&views.sample(), normal.data(), of_coefficients.data()) == WELKIN_OK);
      for (std::size_t c = 0; c < 3; ++c) {
        const double shown = double{image.pixel(x, y)[c]} * f64::kPi / WELKIN_SPHERE_ALBEDO;
        CHECK(shown == Approx(double{e[c]}).epsilon(2e-4 + tolerance(device)));  // the normal is interpolated in float
        difference = std::max(difference, std::abs(double{e[c]} / double{of_coefficients[c]} - 1.0));
      }
    }
  CHECK(difference > 0.1);  // It is not the light of the coefficients.
  CHECK(device.messageCount() == 0);
}

}  // namespace welkin::tests
