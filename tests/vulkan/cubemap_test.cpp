// SPDX-License-Identifier: Apache-2.0
// Cubemaps of every format on the device. Each mip, filtered within faces and across edges and corners, is compared
// with the file's own texels filtered in double.
#include <cmath>
#include <random>

#include "compute.h"
#include "object.h"
#include "shared.h"
#include "sky/cubemap/cubemap_filter.h"
#include "spirv/kCubemapComp.h"
#include "test_sky.h"
#include "worst.h"

namespace welkin::tests {
namespace {

using f64::Number3;
using format::CubemapFormat;

/// RGB of every texel of a mip, faces stacked.
struct Mip {
  int size;
  std::vector<Number3> texel;
};

Mip firstMip(const WelkinCubemap& cube) {
  const auto format = static_cast<CubemapFormat>(cube.format);
  Mip mip{static_cast<int>(cube.size), {}};
  const auto* bytes = static_cast<const unsigned char*>(cube.texels);
  for (std::size_t i = 0; i < std::size_t{6} * cube.size * cube.size; ++i) {
    float rgb[3];
    format::decodeTexel(format, bytes + i * format::texelBytes(format), rgb);
    mip.texel.emplace_back(double{rgb[0]}, double{rgb[1]}, double{rgb[2]});
  }
  return mip;
}

/// Means of squares of four texels. The size is even.
Mip nextMip(const Mip& mip) {
  const int half = mip.size / 2;
  Mip next{half, {}};
  for (int row = 0; row < 6 * half; ++row)
    for (int column = 0; column < half; ++column) {
      Number3 sum(0.0);
      for (int k = 0; k < 4; ++k)
        sum += mip.texel[static_cast<std::size_t>((2 * row + k / 2) * mip.size + 2 * column + k % 2)];
      next.texel.push_back(sum / 4.0);
    }
  return next;
}

Number3 filtered(const Mip& mip, const Number3& direction) {
  Number3 sum(0.0);
  for (const auto& share : cubemap::footprintOf(mip.size, {direction.x, direction.y, direction.z}))
    sum += mip.texel[share.texel] * share.weight;
  return sum;
}

/// Directions spread over the sphere, with more of them close to the edges and corners of the cube.
std::vector<Number3> directions() {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<Number3> list;
  for (int i = 0; i < 6000; ++i) {
    Number3 d(uniform(random), uniform(random), uniform(random));
    if (i % 3 > 0) d[i % 2] = std::copysign(1.0 - 0.05 * std::abs(uniform(random)), d[i % 2]);
    if (i % 3 > 1) d.z = std::copysign(1.0 - 0.05 * std::abs(uniform(random)), d.z);
    const double length = std::sqrt(dot(d, d));
    if (length > 0.1) list.push_back(d / length);
  }
  return list;
}

/// Error bound of a mip's texel, relative to the largest component of the texels around. It is rounded once to a packed
/// format; a blit rounds every mip to a half float.
double roundingOf(CubemapFormat format, int mip) {
  if (mip == 0) return 0.0;
  return format == CubemapFormat::rgba16f ? mip * 0x1p-11 : format == CubemapFormat::rgb9e5 ? 0x1p-9 : 0x1p-6;
}

}  // namespace

TEST_CASE("VulkanCubemap, EveryFormatAndMipIsTheFilesTexelsFiltered", "[vulkan]") {
  render::VulkanDevice device(true);
  // A filtering unit may round its two weights to 8 bits: 2^-9 of the difference of texels (here below 2) for each.
  const double filtering = device.properties().deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU ? 1e-5 : 2.0 * 2.0 / 512.0;
  constexpr double kLargest = 2.0;
  const auto list = directions();
  for (const auto format : {CubemapFormat::rgba16f, CubemapFormat::rgb9e5, CubemapFormat::b10g11r11}) {
    const auto bytes = testSkyFile({.cubemap_format = format});
    const Sky sky = openTestSky(bytes);
    const SkyObject object(device, sky, createInfo(device, 1));
    WelkinSkySample sample{};
    REQUIRE(sky.sample(11.0, sample));
    REQUIRE(welkin_vulkan_update(object.get(), 0, &sample) == WELKIN_OK);
    WelkinCubemap cube{};
    REQUIRE(welkin_sky_cubemap(sky.get(), sample.cubemap[0], &cube) == WELKIN_OK);
    REQUIRE(static_cast<CubemapFormat>(cube.format) == format);
    Mip mip = firstMip(cube);
    for (int level = 0; mip.size > 0; ++level) {
      std::vector<float> input;
      for (const Number3& d : list)
        for (const double v : {d.x, d.y, d.z, double(level)}) input.push_back(static_cast<float>(v));
      const auto results =
          runCompute(device, kCubemapComp, input, 4 * list.size(), 4, welkin_vulkan_descriptor_set_layout(object.get()),
                     welkin_vulkan_descriptor_set(object.get(), 0));
      Worst worst;
      for (std::size_t i = 0; i < list.size(); ++i) {
        const float* d = input.data() + 4 * i;
        const Number3 expected = filtered(mip, Number3(double{d[0]}, double{d[1]}, double{d[2]}));
        for (int c = 0; c < 3; ++c)
          worst.compare(double{results[4 * i + static_cast<std::size_t>(c)]}, expected[c], 1.0, [&] {
            return std::to_string(list[i].x) + " " + std::to_string(list[i].y) + " " + std::to_string(list[i].z);
          });
      }
      CAPTURE(format::nameOf(format), level, worst.where);
      CHECK(worst.error < filtering + kLargest * roundingOf(format, level));
      if (level > 0) CHECK(worst.error > 0.0);
      mip = mip.size > 1 ? nextMip(mip) : Mip{0, {}};
    }
  }
  CHECK(device.messageCount() == 0);
}

}  // namespace welkin::tests
