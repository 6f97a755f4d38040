// SPDX-License-Identifier: Apache-2.0
// The include for the key light, the reflected sky in its mips, and the dither. Also the difference between the baked
// cubemaps and the analytic dome.
#include <algorithm>
#include <cmath>

#include "compute.h"
#include "object.h"
#include "render/views.h"
#include "shared.h"
#include "sky/bake/encode.h"
#include "spirv/kLightComp.h"
#include "test_sky.h"
#include "worst.h"

namespace welkin::tests {
namespace {

using f64::Number3;

/// Mean of a face's texels, the value of its last mip.
Number3 faceMean(const WelkinCubemap& cube, std::size_t face) {
  Number3 sum(0.0);
  const std::size_t texels = std::size_t{cube.size} * cube.size;
  for (std::size_t i = 0; i < texels; ++i) {
    float rgb[3];
    format::decodeTexel(static_cast<format::CubemapFormat>(cube.format),
                        static_cast<const unsigned char*>(cube.texels) + 8 * (face * texels + i), rgb);
    sum += Number3(double{rgb[0]}, double{rgb[1]}, double{rgb[2]});
  }
  return sum / static_cast<double>(texels);
}

}  // namespace

TEST_CASE("VulkanLight, KeyLightAndReflectionEqualTheRuntime", "[vulkan]") {
  constexpr double kHalf = 1.0 / 512.0;  // three blits, each rounded to a half float
  const auto bytes = testSkyFile({});
  const Sky sky = openTestSky(bytes);
  render::VulkanDevice device(true);
  const float axes[6][4] = {{1, 0, 0, 0}, {-1, 0, 0, 0}, {0, 1, 0, 0}, {0, -1, 0, 0}, {0, 0, 1, 0}, {0, 0, -1, 0}};
  const std::vector<float> input(&axes[0][0], &axes[0][0] + 24);
  {
    const SkyObject object(device, sky, createInfo(device, 1));
    for (const double time_h : {11.0, 2.0}) {  // the sun's, the moon's
      WelkinSkySample sample{};
      REQUIRE(sky.sample(time_h, sample));
      REQUIRE(welkin_vulkan_update(object.get(), 0, &sample) == WELKIN_OK);
      const auto results =
          runCompute(device, kLightComp, input, 96, 16, welkin_vulkan_descriptor_set_layout(object.get()),
                     welkin_vulkan_descriptor_set(object.get(), 0));
      WelkinLight key{};
      REQUIRE(welkin_sample_key_light(&sample, &key) == WELKIN_OK);
      CHECK(key.normal_irradiance[1] > 0.0F);
      WelkinCubemap first, second;
      REQUIRE(welkin_sky_cubemap(sky.get(), sample.cubemap[0], &first) == WELKIN_OK);
      REQUIRE(welkin_sky_cubemap(sky.get(), sample.cubemap[1], &second) == WELKIN_OK);
      for (std::size_t i = 0; i < 6; ++i) {
        const float* r = results.data() + 16 * i;
        const double facing =
            std::max(double{axes[i][0]} * double{key.direction[0]} + double{axes[i][1]} * double{key.direction[1]} +
                         double{axes[i][2]} * double{key.direction[2]},
                     0.0);
        const Number3 mean = mix(faceMean(first, i), faceMean(second, i), double{sample.cubemap_weight});
        for (int c = 0; c < 3; ++c) {
          CAPTURE(time_h, i, c);
          CHECK(double{r[c]} == Approx(double{key.normal_irradiance[c]} * facing).epsilon(1e-6).margin(1e-12));
          CHECK(double{r[8 + c]} == Approx(mean[c]).epsilon(kHalf));
          CHECK(double{r[12 + c]} == f64::ditherAt(static_cast<int>(i % 8), static_cast<int>(i / 8)));
        }
        CHECK(std::abs(r[4] - r[8]) > 0.01F * r[8]);  // a mirror shows a texel, not the mean
      }
    }
  }
  CHECK(device.messageCount() == 0);
}

TEST_CASE("Dither, EvenAndBalanced") {
  double sum = 0.0;
  std::vector<bool> seen(64, false);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      const double t = f64::ditherAt(x, y);
      CHECK(std::abs(t) < 0.5);
      sum += t;
      seen[static_cast<std::size_t>((t + 0.5) * 64.0)] = true;
    }
  CHECK(sum == Approx(0.0).margin(1e-12));
  CHECK(std::count(seen.begin(), seen.end(), true) == 64);
}

TEST_CASE("VulkanDome, CubemapsAgreeWithTheFormulas", "[vulkan]") {
  // Bound stated in docs/runtime.md, relative to the pixel's largest channel. It holds for cubemaps of 128 texels at a
  // baked hour, a degree and a half from the horizon's step and six degrees from the sun. Nearer the sun bilinear
  // filtering flattens its cusp.
  constexpr double kBound = 0.008;
  constexpr uint32_t kSize = 192;
  bake::SkyFile file;
  file.sky.luminance = *model::findLuminance("far-cry-3");
  file.sky.sun.path.key_time_h = {0.0};
  file.sky.sun.path.key_azimuth_rad = {0.7};
  file.sky.sun.path.key_elevation_rad = {0.6};
  file.sky.gradient_sun = model::Gradient{1, 3, {1.0F, 0.6F, 0.3F, 0.5F, 0.6F, 0.8F, 0.2F, 0.4F, 0.9F}};
  file.sky.gradient_anti = model::Gradient{1, 2, {0.4F, 0.5F, 0.7F, 0.2F, 0.4F, 0.9F}};
  model::normalise(file.sky.gradient_sun, file.sky.gradient_anti);
  file.settings = "{}";
  file.bake.key_time_h = {0.0};
  file.bake.cubemap_size = 128;
  file.bake.cubemap_time_h = {9.0};
  const model::SkyInstant instant(file.sky, 9.0);
  const auto cube = cubemap::renderCubemap(instant, Number3(0.0), 128, format::CubemapFormat::rgba16f);
  const auto bytes = bake::encodeSky(file, table::bakeDayTable(file.sky, 2, {0.0}, {}), {cube});
  Sky sky;
  REQUIRE(sky.open(bytes.data(), bytes.size()));
  render::VulkanDevice device(true);
  std::vector<render::FloatImage> images;
  for (const auto source : {WELKIN_VULKAN_ANALYTIC, WELKIN_VULKAN_CUBEMAP}) {
    render::Views views(device, sky, source);
    views.setTime(9.0);
    images.push_back(views.dome(kSize, kSize, false));
  }
  Worst worst;
  for (uint32_t y = 0; y < kSize; ++y)
    for (uint32_t x = 0; x < kSize; ++x) {
      const double px = (x + 0.5) * 2.0 / kSize - 1.0, py = (y + 0.5) * 2.0 / kSize - 1.0;
      const double radius = std::hypot(px, py);
      if (radius > 1.0 - 1.5 / 90.0) continue;
      const double h = std::sin(radius * f64::kHalfPi) / radius;
      const Number3 d(-px * h, std::cos(radius * f64::kHalfPi), py * h);
      if (f64::angleBetween(d, instant.sunDirection()) < 6.0 / 180.0 * f64::kPi) continue;
      const float* a = images[0].pixel(x, y);
      const float* b = images[1].pixel(x, y);
      const double scale = double{std::max({a[0], a[1], a[2]})};
      for (int c = 0; c < 3; ++c)
        worst.compare(double{b[c]}, double{a[c]}, scale,
                      [&] { return "pixel " + std::to_string(x) + "," + std::to_string(y); });
    }
  INFO("worst " << worst.error << " at " << worst.where);
  CHECK(worst.error < kBound);
  CHECK(worst.error > 1e-5);
  CHECK(device.messageCount() == 0);
}

}  // namespace welkin::tests
