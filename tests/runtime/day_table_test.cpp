// SPDX-License-Identifier: Apache-2.0
// The day's table, written by hand: its encodings of coefficients and of modes' weights.
#include <welkin/welkin.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "forge.h"
#include "format/container.h"
#include "format/half.h"

namespace welkin::tests {
namespace {

/// Tolerance for the numbers of a sample, which are floats.
constexpr double kFloats = 4.0 * 0x1p-24;

/// Two keys of four rows of three channels, stored in every encoding as random bits, and the decoded values.
struct Numbers {
  DayParts day;
  std::vector<double> value;

  double at(double first_share, std::size_t row, std::size_t channel) const {
    const std::size_t i = row * 3 + channel;
    return first_share * value[i] + (1.0 - first_share) * value[12 + i];
  }
};

Numbers randomNumbers(std::uint8_t encoding) {
  std::mt19937 random(31U + encoding);
  std::uniform_int_distribution<int> byte(-127, 127), word(-32767, 32767), half(0x2c00, 0x3c00);
  std::uniform_real_distribution<float> number(0.25F, 2.0F);
  Numbers numbers;
  numbers.day.encoding = encoding;
  if (encoding > 0) numbers.day.key_scale = {number(random), number(random)};
  for (std::size_t i = 0; i < 12 && encoding >= 2; ++i)
    numbers.day.row_scale.push_back(number(random) / (encoding == 2 ? 32767.0F : 127.0F));
  std::vector<float> floats;
  std::vector<std::uint16_t> words;
  std::vector<std::int8_t> bytes;
  for (std::size_t i = 0; i < 24; ++i) {
    const bool positive = i % 12 < 3 || i % 12 >= 9;  // the mean and the horizontal irradiance
    double stored = 0.0;
    if (encoding == 0) {
      floats.push_back(positive ? number(random) : number(random) - 1.0F);
      stored = double{floats.back()};
    } else if (encoding == 1) {
      const int bits = half(random);
      stored = std::ldexp(1024.0 + (bits & 1023), (bits >> 10) - 25) * (positive || i % 2 == 0 ? 1.0 : -1.0);
      words.push_back(static_cast<std::uint16_t>(stored < 0.0 ? bits | 0x8000 : bits));
    } else if (encoding == 2) {
      const int v = word(random);
      stored = positive ? std::abs(v) : v;
      words.push_back(static_cast<std::uint16_t>(static_cast<std::int16_t>(stored)));
    } else {
      const int v = byte(random);
      stored = positive ? std::abs(v) : v;
      bytes.push_back(static_cast<std::int8_t>(stored));
    }
    if (encoding > 0) stored *= double{numbers.day.key_scale[i / 12]};
    if (encoding >= 2) stored *= double{numbers.day.row_scale[i % 12]};
    numbers.value.push_back(stored);
  }
  numbers.day.numbers = encoding == 0   ? DayParts::bytesOf(floats)
                        : encoding <= 2 ? DayParts::bytesOf(words)
                                        : DayParts::bytesOf(bytes);
  return numbers;
}

/// A file with that table at intensity 1. Neither sun nor moon gives light.
Parts partsOf(const DayParts& day) {
  Parts parts;
  parts.intensity = {};
  parts.sun.illuminance.value = {0.0};
  parts.moon.illuminance.value = {0.0};
  parts.day = day;
  return parts;
}

WelkinSkySample sampleOf(const Parts& parts, double time_h) {
  const std::vector<std::byte> bytes = format::seal(payloadOf(parts));
  WelkinSky* sky = nullptr;
  REQUIRE(welkin_sky_open_memory(bytes.data(), bytes.size(), &sky, nullptr) == WELKIN_OK);
  WelkinSkySample sample{};
  REQUIRE(welkin_sky_sample(sky, time_h, &sample) == WELKIN_OK);
  welkin_sky_close(sky);
  return sample;
}

/// Hours, each with the first key's weight: at the keys, between them, and across midnight.
constexpr std::pair<double, double> kHours[] = {{0.0, 1.0}, {12.0, 0.0}, {3.0, 0.75}, {21.0, 0.75}, {16.0, 1.0 / 3.0}};

}  // namespace

TEST_CASE("DayTable, CoefficientsInEveryEncoding") {
  // With 2 bands the rows are c0, the coefficient of y, and that of the direction to the sun's azimuth. The last is
  // split over x and z.
  for (const std::uint8_t encoding : {0, 1, 2, 3}) {
    const Numbers numbers = randomNumbers(encoding);
    Parts parts = partsOf(numbers.day);
    for (const auto& [time_h, share] : kHours) {
      const WelkinSkySample sample = sampleOf(parts, time_h);
      for (std::size_t c = 0; c < 3; ++c) {
        CAPTURE(int{encoding}, time_h, c);
        const double albedo = 0.1F;
        const double ground = albedo * numbers.at(share, 3, c) / M_PI;
        const auto within = [](double value) { return Approx(value).margin(kFloats * 4.0).epsilon(0.0); };
        CHECK(double{sample.ground_radiance[c]} == within(ground));
        // For a radiance of 1 below the horizon: 2 pi Y00 and -pi Y10(up).
        CHECK(double{sample.radiance_sh[0][c]} == within(numbers.at(share, 0, c) + ground * std::sqrt(M_PI)));
        CHECK(double{sample.radiance_sh[1][c]} ==
              within(numbers.at(share, 1, c) - ground * M_PI * std::sqrt(0.75 / M_PI)));
        CHECK(double{sample.radiance_sh[3][c]} == within(numbers.at(share, 2, c) * double{sample.mode_azimuth[0]}));
        CHECK(double{sample.radiance_sh[2][c]} == within(numbers.at(share, 2, c) * double{sample.mode_azimuth[1]}));
      }
      const float* sun = sample.sun.direction;
      const double length = std::hypot(double{sun[0]}, double{sun[2]});
      CHECK(double{sample.mode_azimuth[0]} == Approx(double{sun[0]} / length).margin(1e-6));
      CHECK(double{sample.mode_azimuth[1]} == Approx(double{sun[2]} / length).margin(1e-6));
    }
  }
}

TEST_CASE("DayTable, WeightsOfModesInEveryEncoding") {
  for (const std::uint8_t encoding : {0, 1, 2, 3}) {
    const Numbers numbers = randomNumbers(encoding);
    DayParts day = withModes(4);
    day.encoding = encoding;
    day.numbers = numbers.day.numbers;
    day.key_scale = numbers.day.key_scale;
    day.row_scale = numbers.day.row_scale;
    for (std::size_t i = 0; i < day.mode_sh.size(); ++i) day.mode_sh[i] = 0.25F * static_cast<float>(i);
    Parts parts = partsOf(day);
    parts.albedo = format::Rgb(0.0F, 0.0F, 0.0F);
    for (const auto& [time_h, share] : kHours) {
      const WelkinSkySample sample = sampleOf(parts, time_h);
      REQUIRE(sample.mode_count == 4);
      for (std::size_t c = 0; c < 3; ++c) {
        CAPTURE(int{encoding}, time_h, c);
        const auto within = [](double value) { return Approx(value).margin(kFloats * 16.0).epsilon(0.0); };
        double c0 = 0.0;
        double c1 = 0.0;
        for (std::size_t k = 0; k < 4; ++k) {
          CHECK(double{sample.mode_weight[k][c]} == within(numbers.at(share, k, c)));
          c0 += numbers.at(share, k, c) * 0.25 * (3.0 * static_cast<double>(k));
          c1 += numbers.at(share, k, c) * 0.25 * (3.0 * static_cast<double>(k) + 1.0);
        }
        CHECK(double{sample.radiance_sh[0][c]} == within(c0));
        CHECK(double{sample.radiance_sh[1][c]} == within(c1));
        for (std::size_t k = 4; k < WELKIN_MAX_MODES; ++k) CHECK(sample.mode_weight[k][c] == 0.0F);
      }
    }
  }
}

}  // namespace welkin::tests
