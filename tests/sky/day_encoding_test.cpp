// SPDX-License-Identifier: Apache-2.0
// The stored numbers of the day's table: the errors stated in sky/table/day_encoding.h, from both sides, and the
// numbers that the runtime reads.
#include "sky/table/day_encoding.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <welkin/welkin.hpp>

#include "format/container.h"
#include "sky/bake/encode.h"
#include "sky/base/toml_table.h"

namespace welkin::tests {
namespace {

/// Scales are floats, rounded up, so a bound that contains them may be exceeded by this factor.
constexpr double kScales = 1.0 + 4.0 * 0x1p-24;
/// Errors reach at least this share of their bound, so an error that is 20 % too large would exceed it.
constexpr double kTight = 0.9;
/// The smallest float. No scale is finer.
constexpr double kSmallest = 0x1p-149;

/// Random signs and magnitudes over `decades`. Every key and every row has its own magnitude, over as many decades.
table::DayTable randomTable(int keys, int rows, int channels, double decades) {
  std::mt19937_64 random(71);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  table::DayTable table;
  table.rows = rows;
  table.channels = channels;
  std::vector<double> of_row(table.numbersOfKey());
  for (double& r : of_row) r = std::pow(10.0, 0.5 * decades * unit(random));
  for (int key = 0; key < keys; ++key) {
    table.key_time_h.push_back(24.0 * key / keys);
    const double of_key = std::pow(10.0, 0.5 * decades * unit(random));
    for (const double r : of_row) table.number.push_back(of_key * r * unit(random));
  }
  return table;
}

double largestOfKey(const table::DayTable& table, std::size_t i) {
  const std::size_t n = table.numbersOfKey();
  double largest = 0.0;
  for (std::size_t j = i / n * n; j < i / n * n + n; ++j) largest = std::max(largest, std::abs(table.number[j]));
  return largest;
}

/// Largest number of number i's row, after each key is divided by its largest.
double largestOfRow(const table::DayTable& table, std::size_t i) {
  double largest = 0.0;
  for (std::size_t j = i % table.numbersOfKey(); j < table.number.size(); j += table.numbersOfKey())
    if (const double of_key = largestOfKey(table, j); of_key > 0.0)
      largest = std::max(largest, std::abs(table.number[j]) / of_key);
  return largest;
}

/// The bound in the header of day_encoding.h as a formula.
double boundOf(const table::DayTable& table, std::size_t i, table::Encoding encoding) {
  const double number = std::abs(table.number[i]);
  const double of_key = largestOfKey(table, i);
  if (encoding == table::Encoding::float32) return std::max(0x1p-24 * number, 0.5 * kSmallest);
  if (encoding == table::Encoding::float16) return std::max(0x1p-11 * number, 0x1p-25 * of_key);
  return of_key * largestOfRow(table, i) / (2.0 * format::factsOf(encoding).largest_integer);
}

/// Largest error over its bound.
double worstOf(const table::DayTable& table, table::Encoding encoding) {
  const std::vector<double> got = table::decodeNumbers(table, table::encodeNumbers(table, encoding));
  double worst = 0.0;
  for (std::size_t i = 0; i < got.size(); ++i)
    if (const double off = std::abs(got[i] - table.number[i]); off > 0.0)
      worst = std::max(worst, off / boundOf(table, i, encoding));
  return worst;
}

}  // namespace

TEST_CASE("DayEncoding, ErrorsAreWithinTheirBoundsAndReachThem") {
  for (const table::Encoding encoding : format::kEncodings)
    for (const double decades : {0.0, 6.0, 24.0})
      for (const int channels : {1, 3}) {
        CAPTURE(nameOf(encoding), decades, channels);
        const double worst = worstOf(randomTable(60, 5, channels, decades), encoding);
        CHECK(worst <= kScales);
        CHECK(worst > kTight);
      }
}

TEST_CASE("DayEncoding, SmallRowsOfAKeyOfHalfsReachTheFloor") {
  // Numbers from 2^-30 to 2^-12 of the largest of their key. Below 2^-14 halfs are evenly spaced and the floor holds.
  table::DayTable table;
  table.rows = 2000;
  table.channels = 1;
  table.key_time_h = {0.0};
  table.number = {3.0};
  for (int i = 1; i < table.rows; ++i) table.number.push_back(3.0 * std::exp2(-30.0 + 18.0 * i / table.rows));
  const std::vector<double> got = table::decodeNumbers(table, table::encodeNumbers(table, table::Encoding::float16));
  double worst = 0.0;
  for (std::size_t i = 1; i < got.size(); ++i)
    if (table.number[i] < 3.0 * 0x1p-14) worst = std::max(worst, std::abs(got[i] - table.number[i]));
  CHECK(worst <= 3.0 * 0x1p-25 * kScales);
  CHECK(worst > kTight * 3.0 * 0x1p-25);
}

TEST_CASE("DayEncoding, ZeroStaysZero") {
  table::DayTable table = randomTable(3, 4, 3, 0.0);
  std::fill(table.number.begin(), table.number.begin() + 12, 0.0);                                    // a key
  for (std::size_t i = 5; i < table.number.size(); i += table.numbersOfKey()) table.number[i] = 0.0;  // a row
  for (const table::Encoding encoding : format::kEncodings) {
    CAPTURE(nameOf(encoding));
    const auto some = table::decodeNumbers(table, table::encodeNumbers(table, encoding));
    for (std::size_t i = 0; i < some.size(); ++i)
      if (table.number[i] == 0.0) CHECK(some[i] == 0.0);
    table::DayTable black = table;
    std::fill(black.number.begin(), black.number.end(), 0.0);
    const auto all = table::decodeNumbers(black, table::encodeNumbers(black, encoding));
    CHECK(std::all_of(all.begin(), all.end(), [](double v) { return v == 0.0; }));
  }
}

TEST_CASE("DayEncoding, OneKeyOfFixedPointIsExact") {
  // With one key the rows' scales are its own numbers, so only their rounding is left.
  const table::DayTable table = randomTable(1, 12, 3, 9.0);
  for (const table::Encoding encoding : {table::Encoding::fixed16, table::Encoding::fixed8}) {
    const auto got = table::decodeNumbers(table, table::encodeNumbers(table, encoding));
    for (std::size_t i = 0; i < got.size(); ++i)
      CHECK(got[i] == Approx(table.number[i]).epsilon(4.0 * 0x1p-24).margin(0.0));
  }
}

TEST_CASE("DayEncoding, DenormalsAreFiniteAndOffByTheSmallestFloat") {
  for (const double magnitude : {1e-38, 1e-43, 1e-46, 1e-300, 5e-324}) {
    table::DayTable table = randomTable(4, 3, 3, 0.0);
    for (double& v : table.number) v *= magnitude;
    for (const table::Encoding encoding : format::kEncodings) {
      CAPTURE(nameOf(encoding), magnitude);
      const auto got = table::decodeNumbers(table, table::encodeNumbers(table, encoding));
      for (std::size_t i = 0; i < got.size(); ++i) {
        REQUIRE(std::isfinite(got[i]));
        CHECK(std::abs(got[i] - table.number[i]) <= boundOf(table, i, encoding) * kScales + kSmallest);
      }
    }
  }
}

TEST_CASE("DayEncoding, BytesAreThoseOfAFile") {
  bake::SkyFile file;
  file.settings = "{}";
  file.bake.cubemap_size = 2;
  file.bake.cubemap_time_h = {6.0, 18.0};
  for (const table::Encoding encoding : format::kEncodings)
    for (const auto format : {format::CubemapFormat::rgba16f, format::CubemapFormat::rgb9e5})
      for (const int keys : {1, 7}) {
        CAPTURE(nameOf(encoding), nameOf(format), keys);
        const table::DayTable table = randomTable(keys, 6, 3, 1.0);
        file.bake.key_time_h = table.key_time_h;
        const cubemap::Cubemap cubemap{2, format, std::vector<std::uint8_t>(format::bytesOfCubemaps(format, 2))};
        const auto bytes = bake::encodeSky(file, table, {cubemap, cubemap}, encoding);
        const format::Opened opened = format::openContainer(bytes);
        REQUIRE(opened.file != nullptr);
        const format::Sky& sky = *opened.file->sky();
        const format::Day& day = *sky.day();
        const auto scales = [](const auto* scale) { return scale == nullptr ? 0 : scale->size(); };
        CHECK(format::bytesOfTable(encoding, table.key_time_h.size(), table.numbersOfKey()) ==
              day.key_time_h()->size() * sizeof(double) + day.numbers()->size() +
                  (scales(day.key_scale()) + scales(day.row_scale())) * sizeof(float));
        std::uint64_t texels = 0;
        for (const auto* stored : *sky.cubemaps()) texels += stored->texels()->size();
        CHECK(format::bytesOfCubemaps(format, 2, 2) == texels);
        CHECK(texels == 2 * 6 * 4 * format::texelBytes(format));
      }
}

TEST_CASE("DayEncoding, TheRuntimeReadsTheSameNumbers") {
  // Weights of twelve modes pass through a sample unchanged.
  for (const table::Encoding encoding : format::kEncodings)
    for (const int channels : {1, 3}) {
      CAPTURE(nameOf(encoding), channels);
      table::DayTable table = randomTable(5, 12, channels, 6.0);
      table.modes = table::ModeTable{12, 2, 2, std::vector<std::uint16_t>(48, 0x3c00), std::vector<float>(36, 1.0F)};
      bake::SkyFile file;
      file.settings = "{}";
      file.bake.key_time_h = table.key_time_h;
      const auto bytes = bake::encodeSky(file, table, {}, encoding);
      welkin::Sky opened;
      const Status status = opened.open(bytes.data(), bytes.size());
      INFO(status.message);
      REQUIRE(status);
      const auto want = table::decodeNumbers(table, table::encodeNumbers(table, encoding));
      for (std::size_t key = 0; key < table.key_time_h.size(); ++key) {
        WelkinSkySample sample{};
        REQUIRE(welkin_sky_sample(opened.get(), table.key_time_h[key], &sample) == WELKIN_OK);
        for (std::size_t row = 0; row < 12; ++row) {
          const auto* numbers = want.data() + key * table.numbersOfKey() + row * static_cast<std::size_t>(channels);
          double largest = 0.0;  // desaturation mixes channels, and rounds to the largest
          for (int c = 0; c < channels; ++c) largest = std::max(largest, std::abs(numbers[c]));
          for (int c = 0; c < 3; ++c)
            CHECK(double{sample.mode_weight[row][c]} ==
                  Approx(numbers[std::min(c, channels - 1)]).margin(0x1p-23 * largest).epsilon(0.0));
        }
      }
    }
}

}  // namespace welkin::tests
