// SPDX-License-Identifier: Apache-2.0
// BC6H blocks against a decoder of this test's own, from the tables of the Khronos Data Format Specification, and the
// errors of the other formats.
#include "maps/bc6h.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "format/cubemap_format.h"
#include "format/half.h"
#include "maps/encoded_cube.h"

namespace welkin::tests {
namespace {

/// Reads bits from the lowest of the first byte on.
struct Bits {
  const unsigned char* bytes;
  int at = 0;
  int next(int count) {
    int value = 0;
    for (int i = 0; i < count; ++i, ++at) value |= (bytes[at / 8] >> (at % 8) & 1) << i;
    return value;
  }
};

/// Decodes one of the four modes with one pair of endpoints.
void decodeBc6h(const unsigned char* block, float (&rgb)[16][3]) {
  static const int kWeights[16] = {0, 4, 9, 13, 17, 21, 26, 30, 34, 38, 43, 47, 51, 55, 60, 64};
  Bits bits{block};
  const int mode = bits.next(5);
  REQUIRE((mode & 3) == 3);
  REQUIRE(mode < 16);
  const int width = mode == 3 ? 10 : mode == 7 ? 11 : mode == 11 ? 12 : 16;
  const int second_width = mode == 3 ? 10 : mode == 7 ? 9 : mode == 11 ? 8 : 4;
  int end[2][3];
  for (int& code : end[0]) code = bits.next(10);
  for (int c = 0; c < 3; ++c) {
    end[1][c] = bits.next(second_width);
    for (int bit = width - 1; bit >= 10; --bit) end[0][c] |= bits.next(1) << bit;
    if (mode == 3) continue;
    const int difference = end[1][c] >= 1 << (second_width - 1) ? end[1][c] - (1 << second_width) : end[1][c];
    end[1][c] = (end[0][c] + difference) & ((1 << width) - 1);
  }
  for (auto& colour : end)
    for (int& code : colour) {
      if (width >= 15 || code == 0) continue;
      code = code == (1 << width) - 1 ? 0xffff : ((code << 16) + 0x8000) >> width;
    }
  for (int texel = 0; texel < 16; ++texel) {
    const int weight = kWeights[bits.next(texel == 0 ? 3 : 4)];
    for (int c = 0; c < 3; ++c)
      rgb[texel][c] = format::floatFromHalf(
          static_cast<std::uint16_t>(((end[0][c] * (64 - weight) + end[1][c] * weight + 32) >> 6) * 31 >> 6));
  }
  REQUIRE(bits.at == 128);
}

/// Largest relative error of a component of a block.
double errorOf(const maps::Bc6hTexels& texels) {
  unsigned char block[maps::kBc6hBytes];
  maps::encodeBc6h(texels, block);
  float rgb[16][3];
  decodeBc6h(block, rgb);
  double worst = 0.0;
  for (std::size_t i = 0; i < 16; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      worst = std::max(worst, std::abs(double{rgb[i][c]} - double{texels[i][c]}) / double{texels[i][c]});
  return worst;
}

constexpr double kHalfStep = 0x1p-10;  // one step of a half: what 16 bits for an endpoint leave of a constant block

}  // namespace

TEST_CASE("Bc6h, ConstantBlocksKeepAHalf") {
  std::mt19937 random(4);
  std::uniform_real_distribution<float> exponent(-12.0F, 15.9F);
  for (int i = 0; i < 500; ++i) {
    maps::Bc6hTexels texels;
    const std::array<float, 3> colour = {std::exp2(exponent(random)), std::exp2(exponent(random)),
                                         std::exp2(exponent(random))};
    texels.fill(colour);
    CAPTURE(colour[0], colour[1], colour[2]);
    REQUIRE(errorOf(texels) <= kHalfStep);
  }
}

TEST_CASE("Bc6h, SmoothBlocksAreWithinAStepOfTheLine") {
  // A ramp of 10 % over the block is a line. Sixteen colours on it are 1/15 of the ramp apart, 0.35 % to either side;
  // rounding of endpoints to 12 bits, the mode that holds such a ramp, adds 0.4 %. Where a component crosses a power of
  // two the line has a bend, because a half's bits change at half the rate there.
  const struct {
    std::array<float, 3> colour;
    double error;
  } cases[] = {{{0.3F, 0.6F, 0.9F}, 0.01}, {{0.3F, 0.5F, 0.9F}, 0.02}};
  for (const auto& one : cases)
    for (int turn = 0; turn < 16; ++turn) {
      maps::Bc6hTexels texels;
      for (int i = 0; i < 16; ++i) {
        const double along = (std::cos(turn * 0.4) * (i % 4 - 1.5) + std::sin(turn * 0.4) * (i / 4 - 1.5)) / 4.3;
        const auto factor = static_cast<float>(std::exp(0.1 * along));
        for (std::size_t c = 0; c < 3; ++c) texels[static_cast<std::size_t>(i)][c] = one.colour[c] * factor;
      }
      CAPTURE(turn, one.colour[1]);
      CHECK(errorOf(texels) < one.error);
    }
}

TEST_CASE("Bc6h, TwoColoursOfAnEdgeAreKept") {
  // Any two colours are the ends of a line. Ten bits for an endpoint leave 1/64 of a colour.
  constexpr double kTenBits = 1.0 / 32.0;
  std::mt19937 random(5);
  std::uniform_real_distribution<float> exponent(-10.0F, 10.0F);
  for (int i = 0; i < 200; ++i) {
    maps::Bc6hTexels texels;
    std::array<float, 3> colour[2];
    for (auto& one : colour)
      for (float& component : one) component = std::exp2(exponent(random));
    for (std::size_t texel = 0; texel < 16; ++texel) texels[texel] = colour[random() & 1];
    CAPTURE(i);
    REQUIRE(errorOf(texels) < kTenBits);
  }
}

TEST_CASE("Bc6h, NumbersOutOfRangeBecomeItsEnds") {
  maps::Bc6hTexels texels;
  texels.fill({1e30F, -1.0F, std::numeric_limits<float>::quiet_NaN()});
  unsigned char block[maps::kBc6hBytes];
  CHECK(maps::encodeBc6h(texels, block) == 16);
  float rgb[16][3];
  decodeBc6h(block, rgb);
  for (const auto& texel : rgb) {
    CHECK(texel[0] == 65504.0F);
    CHECK(texel[1] == 0.0F);
    CHECK(texel[2] == 0.0F);
  }
}

TEST_CASE("EncodedCube, TexelsAreWithinTheFormatsError") {
  std::mt19937 random(6);
  std::uniform_real_distribution<float> exponent(-6.0F, 15.0F);
  maps::Map cube{4, 24, {}};
  for (int i = 0; i < 3 * 4 * 24; ++i) cube.rgb.push_back(std::exp2(exponent(random)));
  const struct {
    maps::Format format;
    format::CubemapFormat texels;
    double error;
  } cases[] = {{maps::Format::rgba16f, format::CubemapFormat::rgba16f, 0x1p-11},
               {maps::Format::rgb9e5, format::CubemapFormat::rgb9e5, 0x1p-9}};
  for (const auto& one : cases) {
    const maps::EncodedCube encoded = maps::encodeCube(cube, one.format, false);
    CHECK(encoded.saturated == 0);
    const std::size_t bytes = format::texelBytes(one.texels);
    for (std::size_t i = 0; i < 96; ++i) {
      float rgb[3];
      format::decodeTexel(one.texels, reinterpret_cast<const unsigned char*>(encoded.levels[0].data()) + i * bytes,
                          rgb);
      const float* expected = cube.rgb.data() + 3 * i;
      const double largest = double{std::max({expected[0], expected[1], expected[2]})};
      for (int c = 0; c < 3; ++c)
        REQUIRE(std::abs(double{rgb[c]} - double{expected[c]}) <=
                one.error * (one.format == maps::Format::rgba16f ? double{expected[c]} : largest));
    }
  }
}

}  // namespace welkin::tests
