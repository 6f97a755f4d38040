// SPDX-License-Identifier: Apache-2.0
// The star map: positions of its stars, their rotation, and the dome's shader against the runtime.
#include <cmath>

#include "object.h"
#include "sky/bake/encode.h"
#include "worst.h"

namespace welkin::tests {
namespace {

constexpr double kLatitude = 0.6;

/// A dark sky with a smooth, asymmetric map, and a little light in the east that fades it.
std::vector<std::byte> starrySky(int bright_column, int bright_row) {
  bake::SkyFile file;
  file.sky.luminance = *model::findLuminance("cie-12");
  file.sky.sun.path = model::LightPath{kLatitude, -0.2, 12.0, 0.3, {}, {}, {}};
  file.sky.intensity = base::Curve::constant(2e-3);
  model::Stars stars;
  stars.width = 32;
  stars.height = 16;
  stars.intensity = 0.02;
  stars.latitude_rad = kLatitude;
  stars.north_offset_rad = 0.3;
  stars.midnight_h = 0.5;
  for (int j = 0; j < stars.height; ++j)
    for (int i = 0; i < stars.width; ++i) {
      const bool star = i == bright_column && j == bright_row;
      const auto smooth = [&](double phase) {
        return static_cast<std::uint8_t>(100.0 + 90.0 * std::sin(phase + 0.39 * i) * std::cos(0.4 * j));
      };
      for (const double phase : {0.0, 1.0, 2.5})
        stars.rgba.push_back(bright_column < 0 ? smooth(phase) : star ? 255 : 0);
      stars.rgba.push_back(255);
    }
  file.sky.stars = stars;
  file.settings = "{}";
  file.bake.key_time_h = {0.0};
  return bake::encodeSky(file, table::bakeDayTable(file.sky, 2, file.bake.key_time_h, {}), {});
}

}  // namespace

TEST_CASE("Stars, MiddleColumnCrossesTheMeridianAtMidnight", "[vulkan]") {
  // The texel right of the middle and one row above the equator: hour angle +half a texel, declination +half a texel.
  const auto bytes = starrySky(16, 7);
  Sky sky;
  REQUIRE(sky.open(bytes.data(), bytes.size()));
  const double step = M_PI / 16.0;
  for (const double time_h : {0.5, 3.5, 22.0}) {
    WelkinSkySample sample{};
    REQUIRE(sky.sample(time_h, sample));
    const auto d =
        f64::celestialDirection(f64::kTwoPi * (time_h - 0.5) / 24.0 + 0.5 * step, 0.5 * step, kLatitude, 0.3);
    REQUIRE(d.y > 0.0);
    const float at[3] = {float(d.x), float(d.y), float(d.z)};
    float centre[3];
    REQUIRE(welkin_star_radiance(sky.get(), &sample, at, centre) == WELKIN_OK);
    CHECK(centre[0] > 0.01F);
    const auto off =
        f64::celestialDirection(f64::kTwoPi * (time_h - 0.5) / 24.0 - 1.0 * step, 0.5 * step, kLatitude, 0.3);
    const float beside[3] = {float(off.x), float(off.y), float(off.z)};
    float none[3];
    REQUIRE(welkin_star_radiance(sky.get(), &sample, beside, none) == WELKIN_OK);
    CHECK(none[0] == 0.0F);
  }
}

TEST_CASE("Stars, FadeBeforeABrightSky", "[vulkan]") {
  CHECK(f64::starFade(0.0, 0.5) == 1.0);
  CHECK(f64::starFade(0.25, 0.5) == Approx(0.5));
  CHECK(f64::starFade(0.5, 0.5) == 0.0);
  CHECK(f64::starFade(9.0, 0.5) == 0.0);
}

TEST_CASE("VulkanStars, EqualTheRuntimePerPixel", "[vulkan]") {
  constexpr uint32_t kSize = 48;
  const auto bytes = starrySky(-1, 0);
  Sky sky;
  REQUIRE(sky.open(bytes.data(), bytes.size()));
  render::VulkanDevice device(true);
  const SkyObject object(device, sky, createInfo(device, 1));
  render::Offscreen target(device, kSize, kSize);
  // Relative to the map's white. The filter's weights have 8 bits on a GPU, and lavapipe decodes sRGB to half a code.
  const double tolerance = device.properties().deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU ? 4e-3 : 1e-2;
  for (const double time_h : {0.5, 7.0, 21.3}) {
    WelkinSkySample sample{};
    REQUIRE(sky.sample(time_h, sample));
    REQUIRE(welkin_vulkan_update(object.get(), 0, &sample) == WELKIN_OK);
    WelkinVulkanView view = fisheye(WELKIN_VULKAN_ANALYTIC);
    const auto draw = [&](VkCommandBuffer c) {
      CHECK(welkin_vulkan_draw_dome(object.get(), c, 0, &view) == WELKIN_OK);
    };
    const auto without = target.render(draw);
    view.discs = 1;
    const auto with = target.render(draw);
    Worst worst;
    double brightest = 0.0;
    for (uint32_t y = 0; y < kSize; ++y)
      for (uint32_t x = 0; x < kSize; ++x) {
        const double px = (x + 0.5) * 2.0 / kSize - 1.0, py = (y + 0.5) * 2.0 / kSize - 1.0;
        const double radius = std::hypot(px, py);
        if (radius > 0.97) continue;
        const double h = std::sin(radius * f64::kHalfPi) / radius;
        const float d[3] = {float(-px * h), float(std::cos(radius * f64::kHalfPi)), float(py * h)};
        float expected[3];
        REQUIRE(welkin_star_radiance(sky.get(), &sample, d, expected) == WELKIN_OK);
        brightest = std::max(brightest, double{expected[2]});
        for (int c = 0; c < 3; ++c)
          worst.compare(double{with.pixel(x, y)[c]} - double{without.pixel(x, y)[c]}, double{expected[c]}, 0.02,
                        [&] { return "pixel " + std::to_string(x) + "," + std::to_string(y); });
      }
    INFO("hour " << time_h << " worst " << worst.error << " at " << worst.where);
    CHECK(worst.error < tolerance);
    CHECK(brightest > 0.002);
  }
  CHECK(device.messageCount() == 0);
}

}  // namespace welkin::tests
