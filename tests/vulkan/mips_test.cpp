// SPDX-License-Identifier: Apache-2.0
// Mips made on the processor: means by area, also for edges that are not powers of two.
#include "vulkan/mips.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

namespace welkin::tests {
namespace {

using format::CubemapFormat;

/// Red grows with columns, green with rows, blue with faces: v = 1 + i.
std::vector<unsigned char> ramps(CubemapFormat format, uint32_t edge) {
  const std::size_t bytes = format::texelBytes(format);
  std::vector<unsigned char> texels(std::size_t{6} * edge * edge * bytes);
  for (std::size_t i = 0; i < std::size_t{6} * edge * edge; ++i) {
    const float rgb[3] = {1.0F + static_cast<float>(i % edge), 1.0F + static_cast<float>(i / edge % edge),
                          1.0F + static_cast<float>(i / edge / edge)};
    format::encodeTexel(format, rgb, texels.data() + i * bytes);
  }
  return texels;
}

}  // namespace

TEST_CASE("Mips, AreMeansOfTheAreasThatTheyCover") {
  constexpr double kMipRounding = 0x1p-7;  // RGB9E5 beside a component up to twice as large; half floats round less.
  for (const CubemapFormat format : {CubemapFormat::rgba16f, CubemapFormat::rgb9e5})
    for (const uint32_t edge : {2U, 3U, 5U, 6U, 7U, 8U, 13U}) {
      const auto texels = ramps(format, edge);
      const std::size_t bytes = format::texelBytes(format);
      std::size_t count = 0;
      for (uint32_t e = edge / 2; e > 0; e /= 2) count += std::size_t{6} * e * e;
      std::vector<unsigned char> mips(count * bytes + 1, 0xcd);
      REQUIRE(vulkan::makeMips(format, edge, texels.data(), mips.data()));
      CHECK(mips.back() == 0xcd);
      std::size_t at = 0;
      for (uint32_t e = edge / 2; e > 0; e /= 2)
        for (std::size_t i = 0; i < std::size_t{6} * e * e; ++i, ++at) {
          float rgb[3];
          format::decodeTexel(format, mips.data() + at * bytes, rgb);
          CAPTURE(format::nameOf(format), edge, e, i, rgb[0], rgb[1], rgb[2]);
          // The mean of every mip is the ramp's. A texel of the first mip lies between those that it covers.
          if (e == 1)
            for (int c = 0; c < 2; ++c) CHECK(double{rgb[c]} == Approx(0.5 * (edge + 1.0)).epsilon(2.0 * kMipRounding));
          CHECK(double{rgb[2]} ==
                Approx(1.0 + std::floor(static_cast<double>(i) / (e * e))).epsilon(2.0 * kMipRounding));
          const double width = double(edge) / e;
          const auto meanOf = [&](std::size_t k) {  // Mean of 1 + floor(x) over [k width, (k + 1) width].
            double sum = 0.0;
            for (uint32_t j = 0; j < edge; ++j)
              sum += (1.0 + j) * std::max(0.0, std::min(j + 1.0, (static_cast<double>(k) + 1.0) * width) -
                                                   std::max(double(j), static_cast<double>(k) * width));
            return sum / width;
          };
          if (e != edge / 2) continue;
          CHECK(double{rgb[0]} == Approx(meanOf(i % e)).margin(kMipRounding * edge));
          CHECK(double{rgb[1]} == Approx(meanOf(i / e % e)).margin(kMipRounding * edge));
        }
    }
}

}  // namespace welkin::tests
