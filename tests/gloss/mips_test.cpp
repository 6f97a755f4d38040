// SPDX-License-Identifier: Apache-2.0
// Mips of normals and gloss, held to a mean over copies of the texels and to Toksvig's formula.
#include "gloss/mips.h"

#include <tbb/global_control.h>

#include <catch2/catch.hpp>
#include <numeric>

#include "bumps.h"

namespace welkin::tests {
namespace {

using det::Number3;

constexpr double kFloat = 1.2e-7;  // rounding of a number near 1 to float, twice

gloss::GlossMap constantGloss(double number) {
  gloss::GlossMap map;
  map.number = number;
  return map;
}

/// The mean of a mip's texel over copies: each texel of mip 0 becomes `mip width` x `mip height` equal ones, so that
/// every texel of the mip holds whole copies.
template <typename Get>
auto meanOfCopies(int column, int row, const gloss::Mip& mip, int from_width, int from_height, Get&& get) {
  auto sum = get(0, 0) * 0.0;
  for (int y = row * from_height; y < (row + 1) * from_height; ++y)
    for (int x = column * from_width; x < (column + 1) * from_width; ++x)
      sum = sum + get(x / mip.width, y / mip.height);
  return sum / (1.0 * from_width * from_height);
}

}  // namespace

TEST_CASE("GlossMips, EveryTexelIsTheMeanOfItsShareWhateverTheSize") {
  for (const auto& [width, height] : {std::pair(8, 8), {7, 5}, {13, 1}, {1, 6}, {15, 12}, {1, 1}}) {
    const gloss::NormalMap map = bumps(width, height, 0.4);
    const double g = 0.7, m = std::pow(2.0, 13.0 * g);
    const auto mips = gloss::mipsOf(map, constantGloss(g));
    REQUIRE(mips.back().width == 1);
    REQUIRE(mips.back().height == 1);
    for (std::size_t k = 0; k < mips.size(); ++k) {
      const gloss::Mip& mip = mips[k];
      REQUIRE(mip.width == std::max(width >> k, 1));
      REQUIRE(mip.height == std::max(height >> k, 1));
      double mean_gloss = 0.0;
      for (int row = 0; row < mip.height; ++row)
        for (int column = 0; column < mip.width; ++column) {
          CAPTURE(width, height, k, row, column);
          const Number3 mean = meanOfCopies(column, row, mip, width, height, [&, w = width](int x, int y) {
            const auto i = 3 * static_cast<std::size_t>(y * w + x);
            return Number3(double{map.xyz[i]}, double{map.xyz[i + 1]}, double{map.xyz[i + 2]});
          });
          const double length = std::sqrt(dot(mean, mean));
          const auto i = static_cast<std::size_t>(row * mip.width + column);
          for (int c = 0; c < 3; ++c)
            REQUIRE(double{mip.normal[3 * i + static_cast<std::size_t>(c)]} == Approx(mean[c] / length).margin(kFloat));
          // 1/m' = 1/m + (1 - |na|)/|na|. The normals' rounding to float moves |na| by 1e-7, which m multiplies.
          const double variance = std::pow(2.0, -13.0 * double{mip.gloss[i]});
          REQUIRE(variance == Approx(1.0 / m + (1.0 - length) / length).epsilon(1e-5).margin(2e-7));
          mean_gloss += double{mip.gloss[i]} / (mip.width * mip.height);
        }
      REQUIRE(mip.mean_gloss == Approx(mean_gloss).epsilon(1e-6));
    }
  }
}

TEST_CASE("GlossMips, AMapWithoutBumpsKeepsItsGlossToTheLastBit") {
  image::Image tilted;
  tilted.width = 37;
  tilted.height = 20;
  for (int i = 0; i < 37 * 20; ++i)
    for (const float v : {0.7F, 0.3F, 0.9F}) tilted.rgb.push_back(v);
  const gloss::NormalMap map = gloss::normalMapOf("tilted", tilted, {});
  for (const double g : {0.0, 0.3, 0.7, 1.0})
    for (const gloss::Mip& mip : gloss::mipsOf(map, constantGloss(g)))
      for (const float value : mip.gloss) REQUIRE(value == static_cast<float>(g));
}

TEST_CASE("GlossMips, TwoOppositeSlopesByHand") {
  const double s = std::sqrt(0.5);
  gloss::NormalMap map;
  map.width = 2;
  map.height = 1;
  for (const double v : {s, 0.0, s, -s, 0.0, s}) map.xyz.push_back(static_cast<float>(v));
  const gloss::Mip mip = gloss::mipsOf(map, constantGloss(1.0)).back();
  REQUIRE(mip.normal == std::vector<float>{0.0F, 0.0F, 1.0F});
  REQUIRE(mip.least_length == Approx(s).epsilon(1e-6));
  // |na| = cos 45 degrees: 8192 |na| / (|na| + 8192 (1 - |na|)) = 2.41350
  REQUIRE(std::pow(2.0, 13.0 * double{mip.gloss[0]}) == Approx(2.41350).epsilon(1e-5));
  REQUIRE(mip.mean_factor == Approx(2.41350 / 8192.0).epsilon(1e-5));
}

TEST_CASE("GlossMips, NormalsThatCancelGiveTheRoughestFlatSurface") {
  gloss::NormalMap map;
  map.width = 2;
  map.height = 1;
  map.xyz = {1.0F, 0.0F, 0.0F, -1.0F, 0.0F, 0.0F};
  const gloss::Mip mip = gloss::mipsOf(map, constantGloss(1.0)).back();
  REQUIRE(mip.normal == std::vector<float>{0.0F, 0.0F, 1.0F});
  REQUIRE(mip.gloss == std::vector<float>{0.0F});
}

TEST_CASE("GlossMips, ATileThatIsMovedByTwoTexelsHasItsMipMovedByOne") {
  constexpr int kWidth = 16, kHeight = 8;
  const gloss::NormalMap map = bumps(kWidth, kHeight, 0.8);
  gloss::NormalMap moved = map;
  for (int row = 0; row < kHeight; ++row)
    for (int column = 0; column < kWidth; ++column)
      for (int c = 0; c < 3; ++c)
        moved.xyz[static_cast<std::size_t>(3 * (row * kWidth + column) + c)] =
            map.xyz[static_cast<std::size_t>(3 * ((row + 6) % kHeight * kWidth + (column + 2) % kWidth) + c)];
  const gloss::Mip mip = gloss::mipsOf(map, constantGloss(0.8))[1];
  const gloss::Mip other = gloss::mipsOf(moved, constantGloss(0.8))[1];
  for (int row = 0; row < mip.height; ++row)
    for (int column = 0; column < mip.width; ++column)
      REQUIRE(other.gloss[static_cast<std::size_t>(row * mip.width + column)] ==
              mip.gloss[static_cast<std::size_t>((row + 3) % mip.height * mip.width + (column + 1) % mip.width)]);
}

TEST_CASE("GlossMips, AGlossMapIsAveragedAsVariance") {
  gloss::NormalMap map;
  map.width = 2;
  map.height = 2;
  for (int i = 0; i < 4; ++i)
    for (const float v : {0.0F, 0.0F, 1.0F}) map.xyz.push_back(v);
  gloss::GlossMap rough;
  rough.width = 2;
  rough.height = 2;
  rough.variance = {0.25F, 0.25F, 0.5F, 0.0625F};
  const auto mips = gloss::mipsOf(map, rough);
  REQUIRE(double{mips[0].gloss[3]} == Approx(4.0 / 13.0).epsilon(1e-6));  // m = 16
  REQUIRE(std::pow(2.0, 13.0 * double{mips[1].gloss[0]}) == Approx(1.0 / 0.265625).epsilon(1e-6));
}

TEST_CASE("GlossMips, AGlossMapOfAnotherSizeCoversTheSamePlace") {
  const gloss::NormalMap map = bumps(6, 4, 0.0);
  for (const auto& [width, height] : {std::pair(3, 2), {12, 8}, {5, 3}, {1, 1}}) {
    gloss::GlossMap rough;
    rough.width = width;
    rough.height = height;
    for (int i = 0; i < width * height; ++i) rough.variance.push_back(1.0F / static_cast<float>(2 + i));
    const double mean = std::accumulate(rough.variance.begin(), rough.variance.end(), 0.0) / (width * height);
    const double last = double{gloss::mipsOf(map, rough).back().gloss[0]};
    CAPTURE(width, height);
    REQUIRE(std::pow(2.0, -13.0 * last) == Approx(mean).epsilon(2e-6));
  }
}

TEST_CASE("GlossMips, LessGlossWithEveryMipAndNeverMoreThanTheTexturesOwn") {
  const auto mips = gloss::mipsOf(bumps(64, 64, 0.3), constantGloss(0.9));
  for (std::size_t k = 1; k < mips.size(); ++k) {
    REQUIRE(mips[k].mean_gloss < mips[k - 1].mean_gloss);
    REQUIRE(mips[k].mean_factor <= 1.0);
  }
  const gloss::AverageFactor average = gloss::averageFactorOf(mips);
  REQUIRE(average.gloss < mips[1].mean_gloss);
  REQUIRE(average.gloss > mips.back().mean_gloss);
  REQUIRE(average.factor == Approx(std::pow(2.0, 13.0 * (average.gloss - 0.9))).epsilon(1e-6));
}

TEST_CASE("GlossMips, SameBitsForAnyNumberOfThreads") {
  const gloss::NormalMap map = bumps(200, 123, 0.5);
  const auto many = gloss::mipsOf(map, constantGloss(0.6));
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const auto alone = gloss::mipsOf(map, constantGloss(0.6));
  REQUIRE(many.size() == alone.size());
  for (std::size_t k = 0; k < many.size(); ++k) {
    REQUIRE(many[k].normal == alone[k].normal);
    REQUIRE(many[k].gloss == alone[k].gloss);
    REQUIRE(many[k].mean_gloss == alone[k].mean_gloss);
  }
}

}  // namespace welkin::tests
