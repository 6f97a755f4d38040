// SPDX-License-Identifier: Apache-2.0
#include "format/cubemap_format.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace welkin::format {
namespace {

static_assert(std::endian::native == std::endian::little, "texels are used as they lie in the file");

constexpr std::uint16_t kHalfOne = 0x3c00;
constexpr int kBias = 15;       // of all exponents in this file
constexpr int kSharedBits = 9;  // in an RGB9E5 component
constexpr int kLowestExponent = -kBias - 1;

/// 2^exponent, for the exponents of floats.
constexpr float powerOfTwo(int exponent) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(exponent + 127) << 23U);
}

/// Value of a float without sign, with 5 bits of exponent and `bits` of mantissa.
float decodeSmall(std::uint32_t code, int bits) {
  const std::uint32_t exponent = (code >> bits) & 31U;
  const std::uint32_t mantissa = code & ((1U << bits) - 1U);
  if (exponent == 0) return static_cast<float>(mantissa) * powerOfTwo(1 - kBias - bits);
  return std::bit_cast<float>(((exponent + 127U - kBias) << 23U) | (mantissa << (23 - bits)));
}

/// Nearest code of a value from 0 to the largest, ties to even. The rounding carry may move into the exponent.
std::uint32_t encodeSmall(float value, int bits) {
  if (value < powerOfTwo(1 - kBias)) {  // a multiple of the smallest step; the product is exact
    return static_cast<std::uint32_t>(std::nearbyint(value * powerOfTwo(kBias - 1 + bits)));
  }
  const auto code = std::bit_cast<std::uint32_t>(value) - ((127U - kBias) << 23U);
  const int drop = 23 - bits;
  const std::uint32_t even = (code >> drop) & 1U;
  return (code + (1U << (drop - 1)) - 1U + even) >> drop;
}

/// Vulkan's conversion. The exponent is that of the largest component, plus one if rounding carries.
std::uint32_t encodeShared(const float (&rgb)[3]) {
  const float largest = std::max({rgb[0], rgb[1], rgb[2]});
  int exponent = kLowestExponent;
  exponent = std::max(static_cast<int>(std::bit_cast<std::uint32_t>(largest) >> 23U) - 127, exponent) + 1 + kBias;
  const auto scaleOf = [](int e) { return powerOfTwo(kBias + kSharedBits - e); };
  const auto round = [](float v) { return static_cast<std::uint32_t>(std::floor(double{v} + 0.5)); };
  if (round(largest * scaleOf(exponent)) == 1U << kSharedBits) ++exponent;
  const float scale = scaleOf(exponent);
  return round(rgb[0] * scale) | round(rgb[1] * scale) << 9U | round(rgb[2] * scale) << 18U |
         static_cast<std::uint32_t>(exponent) << 27U;
}

}  // namespace

void decodeTexel(CubemapFormat format, const unsigned char* texel, float (&rgb)[3]) {
  if (format == CubemapFormat::rgba16f) {
    std::uint16_t half[3];
    std::memcpy(half, texel, sizeof half);
    for (int c = 0; c < 3; ++c) rgb[c] = decodeSmall(half[c], 10);
    return;
  }
  std::uint32_t word = 0;
  std::memcpy(&word, texel, sizeof word);
  if (format == CubemapFormat::rgb9e5) {
    const float step = powerOfTwo(static_cast<int>(word >> 27U) - kBias - kSharedBits);
    for (unsigned c = 0; c < 3; ++c) rgb[c] = static_cast<float>((word >> (9U * c)) & 511U) * step;
    return;
  }
  rgb[0] = decodeSmall(word & 2047U, 6);
  rgb[1] = decodeSmall((word >> 11U) & 2047U, 6);
  rgb[2] = decodeSmall(word >> 22U, 5);
}

std::size_t encodeTexel(CubemapFormat format, const float (&rgb)[3], unsigned char* texel) {
  float v[3];
  std::size_t past = 0;
  for (int c = 0; c < 3; ++c) {
    const float largest = largestOf(format, c);
    if (rgb[c] > largest) ++past;
    v[c] = rgb[c] > 0.0F ? std::min(rgb[c], largest) : 0.0F;
  }
  if (format == CubemapFormat::rgba16f) {
    std::uint16_t half[4] = {0, 0, 0, kHalfOne};
    for (int c = 0; c < 3; ++c) half[c] = static_cast<std::uint16_t>(encodeSmall(v[c], 10));
    std::memcpy(texel, half, sizeof half);
  } else {
    const std::uint32_t word = format == CubemapFormat::rgb9e5
                                   ? encodeShared(v)
                                   : encodeSmall(v[0], 6) | encodeSmall(v[1], 6) << 11U | encodeSmall(v[2], 5) << 22U;
    std::memcpy(texel, &word, sizeof word);
  }
  return past;
}

bool hasOnlyLight(CubemapFormat format, const unsigned char* texels, std::size_t count) {
  bool good = true;  // without an early exit: one pass that vectorises
  if (format == CubemapFormat::rgba16f) {
    for (std::size_t i = 0; i < 4 * count; ++i) {
      std::uint16_t half = 0;
      std::memcpy(&half, texels + 2 * i, sizeof half);
      good &= half < 0x7c00;
    }
  } else if (format == CubemapFormat::b10g11r11) {
    constexpr std::uint32_t kExponents[3] = {0x7c0U, 0x7c0U << 11U, 0x3e0U << 22U};
    for (std::size_t i = 0; i < count; ++i) {
      std::uint32_t word = 0;
      std::memcpy(&word, texels + 4 * i, sizeof word);
      for (const std::uint32_t all : kExponents) good &= (word & all) != all;
    }
  }
  return good;
}

}  // namespace welkin::format
