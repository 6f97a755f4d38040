// SPDX-License-Identifier: Apache-2.0
// Two skies at once: a blend of both domes, a blend of their light, and two thousand frames of blending.
#include <cmath>

#include "object.h"
#include "test_sky.h"

namespace welkin::tests {

TEST_CASE("VulkanWeather, OpacityMixesTheDomes", "[vulkan]") {
  constexpr uint32_t kSize = 24;
  constexpr float kWeight = 0.3F;
  constexpr double kTolerance = 1e-6;  // one blend in float
  const auto first_bytes = testSkyFile({});
  const auto second_bytes = testSkyFile({.normalise_to_sun = false});
  const Sky first = openTestSky(first_bytes);
  const Sky second = openTestSky(second_bytes);
  render::VulkanDevice device(true);
  const SkyObject a(device, first, createInfo(device, 1));
  const SkyObject b(device, second, createInfo(device, 1));
  WelkinSkySample s{}, t{};
  REQUIRE(first.sample(9.5, s));
  REQUIRE(second.sample(9.5, t));
  REQUIRE(welkin_vulkan_update(a.get(), 0, &s) == WELKIN_OK);
  REQUIRE(welkin_vulkan_update(b.get(), 0, &t) == WELKIN_OK);
  render::Offscreen target(device, kSize, kSize);
  WelkinVulkanView view = fisheye(WELKIN_VULKAN_ANALYTIC);
  const auto draw = [&](const SkyObject& object, float opacity) {
    view.opacity = opacity;
    return [&object, shown = view](VkCommandBuffer c) {
      CHECK(welkin_vulkan_draw_dome(object.get(), c, 0, &shown) == WELKIN_OK);
    };
  };
  const auto only_a = target.render(draw(a, 0.0F));
  const auto only_b = target.render(draw(b, 1.0F));
  const auto both = target.render([&](VkCommandBuffer c) {
    draw(a, 1.0F)(c);
    draw(b, kWeight)(c);
  });
  double difference = 0.0;
  for (std::size_t i = 0; i < both.rgba.size(); ++i) {
    const double expected = double{only_a.rgba[i]} * (1.0 - double{kWeight}) + double{only_b.rgba[i]} * double{kWeight};
    CHECK(double{both.rgba[i]} == Approx(expected).epsilon(kTolerance).margin(1e-9));
    difference = std::max(difference, std::abs(double{only_a.rgba[i]} - double{only_b.rgba[i]}));
  }
  CHECK(difference > 0.1);  // The two skies differ.
  view.opacity = 1.5F;
  device.execute(
      [&](VkCommandBuffer c) { CHECK(welkin_vulkan_draw_dome(a.get(), c, 0, &view) == WELKIN_ERROR_ARGUMENT); });
  CHECK(device.messageCount() == 0);
}

TEST_CASE("VulkanWeather, TwoThousandFramesOfADayAreSilent", "[vulkan]") {
  constexpr uint32_t kFrames = 2000;
  const auto first_bytes = testSkyFile({.disc_radius_rad = 0.02});
  const auto second_bytes = testSkyFile({.normalise_to_sun = false});
  const Sky first = openTestSky(first_bytes);
  const Sky second = openTestSky(second_bytes);
  render::VulkanDevice device(true);
  const SkyObject a(device, first, createInfo(device, 2));
  const SkyObject b(device, second, createInfo(device, 2));
  render::Offscreen target(device, 8, 8);
  WelkinSkySample s{}, t{}, blended{};
  for (uint32_t i = 0; i < kFrames; ++i) {
    const double time_h = 24.0 * i / kFrames;
    const float weight = 0.5F + 0.49F * std::sin(0.01F * static_cast<float>(i));
    const uint32_t frame = i % 2;
    REQUIRE(first.sample(time_h, s));
    REQUIRE(second.sample(time_h, t));
    REQUIRE(welkin_sample_blend(&s, &t, weight, &blended) == WELKIN_OK);
    REQUIRE(welkin_vulkan_update(a.get(), frame, &s) == WELKIN_OK);
    REQUIRE(welkin_vulkan_update_ambient(a.get(), frame, &blended) == WELKIN_OK);
    REQUIRE(welkin_vulkan_update(b.get(), frame, &t) == WELKIN_OK);
    const auto image = target.render([&](VkCommandBuffer c) {
      WelkinVulkanView view = fisheye(i % 3 == 0 ? WELKIN_VULKAN_CUBEMAP : WELKIN_VULKAN_ANALYTIC);
      view.discs = 1;
      REQUIRE(welkin_vulkan_draw_dome(a.get(), c, frame, &view) == WELKIN_OK);
      view.opacity = weight;
      REQUIRE(welkin_vulkan_draw_dome(b.get(), c, frame, &view) == WELKIN_OK);
    });
    for (const float v : image.rgba) REQUIRE((std::isfinite(v) && v >= 0.0F));
  }
  CHECK(device.messageCount() == 0);
}

}  // namespace welkin::tests
