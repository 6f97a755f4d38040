// SPDX-License-Identifier: Apache-2.0
// Texels: the codes of other implementations, the nearest value by search, and the edges of every format.
#include "format/cubemap_format.h"

#include <Imath/half.h>

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace welkin::format {
namespace {

constexpr CubemapFormat kFormats[] = {CubemapFormat::rgba16f, CubemapFormat::rgb9e5, CubemapFormat::b10g11r11};

std::uint32_t wordOf(CubemapFormat format, float r, float g, float b) {
  unsigned char texel[kMostTexelBytes] = {};
  encodeTexel(format, {r, g, b}, texel);
  std::uint32_t word = 0;
  std::memcpy(&word, texel, sizeof word);
  return word;
}

void roundTrip(CubemapFormat format, const float (&rgb)[3], float (&out)[3]) {
  unsigned char texel[kMostTexelBytes];
  encodeTexel(format, rgb, texel);
  decodeTexel(format, texel, out);
}

/// Every value of a small float, by its definition; ascending.
std::vector<double> valuesOf(int bits) {
  std::vector<double> values;
  for (int e = 0; e < 31; ++e)
    for (int m = 0; m < 1 << bits; ++m)
      values.push_back(e == 0 ? std::ldexp(m, -14 - bits) : std::ldexp((1 << bits) + m, e - 15 - bits));
  return values;
}

}  // namespace

TEST_CASE("CubemapFormat, HalfIsImaths") {
  std::mt19937 random(3);
  for (int i = 0; i < 400000; ++i) {
    float value = std::bit_cast<float>(static_cast<std::uint32_t>(random()) & 0x477fe000U);  // of [0, 65504]
    if (i % 2 == 1) value = std::nextafter(value, i % 4 == 1 ? 0.0F : 70000.0F);             // by the ties
    if (value > 65504.0F) continue;
    const float odd =
        std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) | (static_cast<std::uint32_t>(random()) & 0x1fffU));
    for (const float v : {value, std::min(odd, 65504.0F)}) {
      unsigned char texel[8];
      CHECK(encodeTexel(CubemapFormat::rgba16f, {v, 0.0F, 1.0F}, texel) == 0);
      std::uint16_t half[4];
      std::memcpy(half, texel, sizeof half);
      if (half[0] != Imath::half(v).bits() || half[1] != 0 || half[2] != 0x3c00 || half[3] != 0x3c00) FAIL(v);
      float rgb[3];
      decodeTexel(CubemapFormat::rgba16f, texel, rgb);
      if (rgb[0] != static_cast<float>(Imath::half(v))) FAIL(v);
    }
  }
}

TEST_CASE("CubemapFormat, SmallFloatsAreTheNearestOfAllValues") {
  std::mt19937 random(4);
  std::uniform_real_distribution<float> exponent(-22.0F, 15.9F);
  const std::vector<double> red = valuesOf(6);
  const std::vector<double> blue = valuesOf(5);
  const auto nearest = [](const std::vector<double>& values, double v) {
    const auto after = std::lower_bound(values.begin(), values.end(), v);
    if (after == values.end()) return values.back();
    if (after == values.begin()) return values.front();
    const double low = *(after - 1);
    const double high = *after;
    if (v - low != high - v) return v - low < high - v ? low : high;
    return (after - values.begin()) % 2 == 0 ? high : low;  // ties to even codes
  };
  for (int i = 0; i < 20000; ++i) {
    float rgb[3] = {std::exp2(exponent(random)), 0.0F, std::exp2(exponent(random))};
    rgb[1] = static_cast<float>(
        0.5 * (red[static_cast<std::size_t>(i) % 1900] + red[static_cast<std::size_t>(i) % 1900 + 1]));
    float out[3];
    roundTrip(CubemapFormat::b10g11r11, rgb, out);
    CAPTURE(rgb[0], rgb[1], rgb[2]);
    REQUIRE(double{out[0]} == nearest(red, double{rgb[0]}));
    REQUIRE(double{out[1]} == nearest(red, double{rgb[1]}));
    REQUIRE(double{out[2]} == nearest(blue, double{rgb[2]}));
  }
}

TEST_CASE("CubemapFormat, SharedExponentIsVulkansConversion") {
  // Vulkan 1.3, "RGB to Shared Exponent Conversion", in double and as it is written there.
  const auto reference = [](const float(&rgb)[3]) {
    constexpr int kN = 9;
    constexpr int kB = 15;
    const double largest = std::max({double{rgb[0]}, double{rgb[1]}, double{rgb[2]}});
    const int before =
        (largest > 0.0 ? std::max(-kB - 1, static_cast<int>(std::floor(std::log2(largest)))) : -kB - 1) + 1 + kB;
    const double rounded = std::floor(largest / std::exp2(before - kB - kN) + 0.5);
    const int exponent = rounded == 512.0 ? before + 1 : before;
    std::uint32_t word = static_cast<std::uint32_t>(exponent) << 27U;
    for (unsigned c = 0; c < 3; ++c)
      word |= static_cast<std::uint32_t>(std::floor(double{rgb[c]} / std::exp2(exponent - kB - kN) + 0.5)) << (9U * c);
    return word;
  };
  std::mt19937 random(5);
  std::uniform_real_distribution<float> exponent(-28.0F, 15.99F);
  for (int i = 0; i < 100000; ++i) {
    float rgb[3];
    for (float& v : rgb) v = std::min(std::exp2(exponent(random)), 65408.0F);
    if (i % 5 == 0) rgb[i % 3] = std::nextafter(std::exp2(std::floor(exponent(random))), 0.0F);  // carries
    if (wordOf(CubemapFormat::rgb9e5, rgb[0], rgb[1], rgb[2]) != reference(rgb))
      FAIL(rgb[0] << " " << rgb[1] << " " << rgb[2]);
    float out[3];
    roundTrip(CubemapFormat::rgb9e5, rgb, out);
    const double largest = std::max({double{rgb[0]}, double{rgb[1]}, double{rgb[2]}, 0x1p-16});
    for (int c = 0; c < 3; ++c) REQUIRE(std::abs(double{out[c]} - double{rgb[c]}) <= 0x1p-9 * largest);
  }
}

TEST_CASE("CubemapFormat, WhereEachChannelLies") {
  // One, a half and two: their exponents are 15, 14 and 16.
  CHECK(wordOf(CubemapFormat::b10g11r11, 1.0F, 0.5F, 2.0F) == (15U << 6U | 14U << 17U | 16U << 27U));
  CHECK(wordOf(CubemapFormat::rgb9e5, 1.0F, 0.5F, 2.0F) == (128U | 64U << 9U | 256U << 18U | 17U << 27U));
}

TEST_CASE("CubemapFormat, SaturatesAndCountsAndHasNoNegativeLight") {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  for (const CubemapFormat format : kFormats) {
    CAPTURE(nameOf(format));
    unsigned char texel[kMostTexelBytes];
    float rgb[3];
    CHECK(encodeTexel(format, {1e6F, kInfinity, 70000.0F}, texel) == 3);
    decodeTexel(format, texel, rgb);
    for (int c = 0; c < 3; ++c) CHECK(rgb[c] == largestOf(format, c));
    CHECK(hasOnlyLight(format, texel, 1));
    float at[3];
    float past[3];
    for (int c = 0; c < 3; ++c) {
      at[c] = largestOf(format, c);
      past[c] = std::nextafter(at[c], kInfinity);
    }
    CHECK(encodeTexel(format, at, texel) == 0);
    CHECK(encodeTexel(format, past, texel) == 3);
    CHECK(encodeTexel(format, {-1.0F, kNan, -0.0F}, texel) == 0);
    decodeTexel(format, texel, rgb);
    for (int c = 0; c < 3; ++c) CHECK(std::bit_cast<std::uint32_t>(rgb[c]) == 0U);
    CHECK(encodeTexel(format, {1e-45F, 1e-30F, 0.0F}, texel) == 0);
    decodeTexel(format, texel, rgb);
    for (int c = 0; c < 3; ++c) CHECK(rgb[c] == 0.0F);
  }
}

TEST_CASE("CubemapFormat, RelativeErrorsAreThoseStated") {
  std::mt19937 random(6);
  std::uniform_real_distribution<float> exponent(-13.9F, 15.5F);
  for (const CubemapFormat format : kFormats) {
    double worst[3] = {};
    for (int i = 0; i < 200000; ++i) {
      const float v = std::exp2(exponent(random));
      float out[3];
      roundTrip(format, {v, v, v}, out);
      for (int c = 0; c < 3; ++c) worst[c] = std::max(worst[c], std::abs(double{out[c]} / double{v} - 1.0));
    }
    for (int c = 0; c < 3; ++c) {
      const double stated = format == CubemapFormat::rgba16f  ? 0x1p-11
                            : format == CubemapFormat::rgb9e5 ? 0x1p-9
                            : c < 2                           ? 0x1p-7
                                                              : 0x1p-6;
      CAPTURE(nameOf(format), c, worst[c]);
      CHECK(worst[c] <= stated);
      CHECK(worst[c] > stated / 1.2);
    }
  }
}

TEST_CASE("CubemapFormat, OnlyLightIsLetPass") {
  const auto check = [](CubemapFormat format, std::vector<std::uint32_t> words) {
    return hasOnlyLight(format, reinterpret_cast<const unsigned char*>(words.data()),
                        words.size() * 4 / texelBytes(format));
  };
  CHECK(check(CubemapFormat::rgb9e5, {0xffffffffU, 0U}));
  CHECK(check(CubemapFormat::rgba16f, {0x7bff7bffU, 0x3c007bffU}));
  for (const std::uint32_t bad : {0x7c00U, 0xfe00U, 0x8001U, 0x7c000000U, 0x80000000U})
    for (const bool second : {false, true})
      CHECK_FALSE(check(CubemapFormat::rgba16f, {0U, 0U, second ? 0U : bad, second ? bad : 0U}));
  CHECK(check(CubemapFormat::b10g11r11, {0x7bfU | 0x7bfU << 11U | 0x3dfU << 22U}));
  for (const std::uint32_t bad : {0x7c0U, 0x7c0U << 11U, 0x3e0U << 22U, 0x7ffU, 0x7ffU << 11U, 0x3ffU << 22U})
    CHECK_FALSE(check(CubemapFormat::b10g11r11, {0U, bad}));
}

}  // namespace welkin::format
