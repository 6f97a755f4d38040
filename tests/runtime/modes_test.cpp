// SPDX-License-Identifier: Apache-2.0
// Irradiance from a file's modes, by hand: positions in the map, lower normals, grey, encodings, blends.
#include <welkin/sky_constants.h>
#include <welkin/welkin.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <random>

#include "forge.h"
#include "format/container.h"
#include "shared.h"

namespace welkin::tests {
namespace {

using f64::Number3;

/// Tolerance relative to the largest term: samples are floats, and sums have up to nine terms.
constexpr double kModeFloats = 9.0 * 0x1p-24;

struct Opened {
  explicit Opened(const Parts& parts) : bytes(format::seal(payloadOf(parts))) {
    WelkinMessage message{};
    const WelkinResult result = welkin_sky_open_memory(bytes.data(), bytes.size(), &sky, &message);
    INFO(message.text);
    REQUIRE(result == WELKIN_OK);
  }
  ~Opened() { welkin_sky_close(sky); }
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;

  WelkinSkySample at(double time_h) const {
    WelkinSkySample sample{};
    REQUIRE(welkin_sky_sample(sky, time_h, &sample) == WELKIN_OK);
    return sample;
  }

  std::vector<std::byte> bytes;
  WelkinSky* sky = nullptr;
};

/// The half float of a value. Exact for multiples of 1/64 in [-16, 16].
std::uint16_t halfOf(double value) {
  if (value == 0.0) return 0;
  int exponent = 0;
  const double fraction = std::frexp(std::abs(value), &exponent);  // in [1/2, 1)
  const int mantissa = static_cast<int>(std::lround(fraction * 2048.0)) - 1024;
  return static_cast<std::uint16_t>((value < 0.0 ? 0x8000 : 0) | ((exponent + 14) << 10) | mantissa);
}

/// Modes of noise, made of whole 64ths, with the numbers that a test compares.
struct ModesOf {
  std::size_t count, columns, rows;
  std::vector<double> texel;   ///< row, column, mode
  std::vector<double> weight;  ///< key, mode, channel

  double texelAt(std::size_t row, std::size_t column, std::size_t mode) const {
    return texel[(row * columns + column) * count + mode];
  }
};

ModesOf randomModes(std::uint8_t count, std::uint16_t columns, std::uint16_t rows) {
  std::mt19937 random(21);
  std::uniform_int_distribution<int> number(-60, 60);
  ModesOf modes{count, columns, rows, {}, {}};
  for (std::size_t i = 0; i < std::size_t{count} * columns * rows; ++i)
    modes.texel.push_back((number(random) + (i % count == 0 ? 400 : 0)) / 64.0);
  for (std::size_t i = 0; i < std::size_t{2} * count * 3; ++i)
    modes.weight.push_back((number(random) + (i / 3 % count == 0 ? 64 : 0)) / 64.0);
  return modes;
}

/// A file with the modes and a moon that gives no light. Its ground is black unless a test gives an albedo.
Parts partsOf(const ModesOf& modes, std::uint8_t bands = 2) {
  std::mt19937 random(22);
  std::uniform_real_distribution<float> number(-0.5F, 0.5F);
  Parts parts;
  parts.albedo = format::Rgb(0.0F, 0.0F, 0.0F);
  parts.intensity = {};
  parts.cubemap_size = 0;
  parts.cubemap_time_h.clear();
  parts.moon.illuminance.value = {0.0};
  DayParts& day = parts.day;
  day.bands = bands;
  day.rows = static_cast<std::uint8_t>(modes.count);
  day.mode_count = day.rows;
  day.mode_columns = static_cast<std::uint16_t>(modes.columns);
  day.mode_rows = static_cast<std::uint16_t>(modes.rows);
  for (const double v : modes.texel) day.mode_texels.push_back(halfOf(v));
  day.mode_sh.resize(modes.count * bands * (bands + 1U) / 2);
  for (float& v : day.mode_sh) v = number(random);
  day.numbers = DayParts::bytesOf(std::vector<float>(modes.weight.begin(), modes.weight.end()));
  return parts;
}

Number3 vectorOf(const float v[3]) {
  return {double{v[0]}, double{v[1]}, double{v[2]}};
}

Number3 irradianceOf(const WelkinSky* sky, const WelkinSkySample& sample, const Number3& n) {
  const float normal[3] = {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
  float e[3];
  REQUIRE(welkin_sky_irradiance(sky, &sample, normal, e) == WELKIN_OK);
  return vectorOf(e);
}

/// The upper normal with component y, at an azimuth counted from the sun's to the right.
Number3 normalAt(const WelkinSkySample& sample, double azimuth_rad, double y) {
  const double x = double{sample.mode_azimuth[0]};
  const double z = double{sample.mode_azimuth[1]};
  const double across = std::sqrt(1.0 - y * y);
  const double along = across * std::cos(azimuth_rad);
  const double aside = across * std::sin(azimuth_rad);
  return {along * x - aside * z, y, along * z + aside * x};
}

/// n . V, from the first moments of the radiance, which the coefficients give.
Number3 netOf(const WelkinSkySample& sample, const Number3& n) {
  return (vectorOf(sample.ambient_sh[3]) * n.x + vectorOf(sample.ambient_sh[1]) * n.y +
          vectorOf(sample.ambient_sh[2]) * n.z) *
         std::sqrt(4.0 * M_PI / 3.0);
}

void checkNear(const Number3& value, const Number3& expected, double scale) {
  CAPTURE(value.x, value.y, value.z, expected.x, expected.y, expected.z);
  for (int c = 0; c < 3; ++c) CHECK(std::abs(value[c] - expected[c]) <= kModeFloats * scale);
}

}  // namespace

TEST_CASE("Modes, BilinearBetweenTexelCentres") {
  // Column i of C is at the azimuth with the cosine 2 i / (C - 1) - 1. Row j of R is at y = r (2 - r), r = j / (R - 1).
  const ModesOf modes = randomModes(5, 6, 4);
  const Opened file(partsOf(modes));
  const double scale = 20.0 * 6.0 * 5.0;  // normals are floats: their error moves a texel's difference by 6 of 2^-24
  for (const double time_h : {0.0, 12.0, 18.0}) {
    const WelkinSkySample sample = file.at(time_h);
    REQUIRE(sample.mode_count == 5);
    const auto weight = [&](std::size_t k, std::size_t c) {
      const double first = modes.weight[k * 3 + c];
      const double second = modes.weight[(5 + k) * 3 + c];
      return time_h == 0.0 ? first : time_h == 12.0 ? second : 0.5 * (first + second);
    };
    for (const double column : {0.0, 1.0, 2.25, 3.5, 4.75, 5.0})
      for (const double row : {0.0, 1.0, 1.5, 2.125})
        for (const double side : {1.0, -1.0}) {
          const double r = row / 3.0;
          const Number3 n = normalAt(sample, side * std::acos(2.0 * column / 5.0 - 1.0), r * (2.0 - r));
          const auto i = static_cast<std::size_t>(column);
          const auto j = static_cast<std::size_t>(row);
          const double x = column - static_cast<double>(i);
          const double t = row - static_cast<double>(j);
          Number3 expected;
          for (std::size_t k = 0; k < 5; ++k) {
            const std::size_t right = std::min<std::size_t>(i + 1, 5);
            const std::size_t high = std::min<std::size_t>(j + 1, 3);
            const double low_row = modes.texelAt(j, i, k) * (1.0 - x) + modes.texelAt(j, right, k) * x;
            const double high_row = modes.texelAt(high, i, k) * (1.0 - x) + modes.texelAt(high, right, k) * x;
            for (std::size_t c = 0; c < 3; ++c)
              expected[static_cast<int>(c)] += weight(k, c) * (low_row * (1.0 - t) + high_row * t);
          }
          expected = {std::max(expected.x, 0.0), std::max(expected.y, 0.0), std::max(expected.z, 0.0)};
          CAPTURE(time_h, column, row, side);
          checkNear(irradianceOf(file.sky, sample, n), expected, scale);
        }
  }
}

TEST_CASE("Modes, PolesAreReadBetweenTheMiddleColumns") {
  const ModesOf modes = randomModes(3, 4, 3);
  const Opened file(partsOf(modes));
  const WelkinSkySample sample = file.at(0.0);
  Number3 zenith;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t c = 0; c < 3; ++c)
      zenith[static_cast<int>(c)] += modes.weight[k * 3 + c] * 0.5 * (modes.texelAt(2, 1, k) + modes.texelAt(2, 2, k));
  checkNear(irradianceOf(file.sky, sample, {0.0, 1.0, 0.0}), zenith, 20.0);
  const Number3 nadir = zenith + netOf(sample, {0.0, -1.0, 0.0});
  checkNear(irradianceOf(file.sky, sample, {0.0, -1.0, 0.0}),
            {std::max(nadir.x, 0.0), std::max(nadir.y, 0.0), std::max(nadir.z, 0.0)}, 20.0);
}

TEST_CASE("Modes, GroundHasTheIrradianceOfTheZenithsNormal") {
  const ModesOf modes = randomModes(6, 5, 4);
  Parts parts = partsOf(modes);
  parts.sun.illuminance.value = {0.0};
  parts.intensity.value = {2.0};
  parts.albedo = format::Rgb(0.5F, 0.25F, 0.125F);
  const Opened file(parts);
  const WelkinSkySample sample = file.at(12.0);
  for (std::size_t c = 0; c < 3; ++c) {
    double horizontal = 0.0;
    for (std::size_t k = 0; k < 6; ++k) horizontal += modes.weight[(6 + k) * 3 + c] * modes.texelAt(3, 2, k);
    REQUIRE(horizontal > 0.1);
    const double albedo = std::ldexp(1.0, -1 - static_cast<int>(c));
    CHECK(double{sample.ground_radiance[c]} == Approx(2.0 * albedo * horizontal / M_PI).epsilon(kModeFloats));
  }
}

TEST_CASE("Modes, OppositeNormalsDifferByTheNetFlux") {
  const ModesOf modes = randomModes(8, 5, 7);
  for (const float albedo : {0.0F, 0.4F}) {
    Parts parts = partsOf(modes, 3);
    parts.albedo = format::Rgb(albedo, 0.5F * albedo, 0.2F * albedo);
    const Opened file(parts);
    const WelkinSkySample sample = file.at(7.0);
    for (const double azimuth_rad : {0.3, -1.2, 2.9})
      for (const double y : {1e-6, 0.2, 0.7, 0.999}) {
        const Number3 n = normalAt(sample, azimuth_rad, y);
        const Number3 above = irradianceOf(file.sky, sample, n);
        const Number3 below = irradianceOf(file.sky, sample, -n);
        REQUIRE((above.x > 0.0 && below.x > 0.0));
        checkNear(above - below, netOf(sample, n), 20.0);
      }
  }
}

TEST_CASE("Modes, GroundUnderABlackSkyIsAHalfSphere") {
  // Radiance G below the horizon: E(n) = pi G (1 - n_y) / 2 above and below alike.
  ModesOf modes = randomModes(2, 3, 3);
  std::fill(modes.weight.begin(), modes.weight.end(), 0.0);
  Parts parts = partsOf(modes);
  parts.albedo = format::Rgb(0.5F, 0.3F, 0.1F);
  const Opened file(parts);
  const WelkinSkySample sample = file.at(12.0);  // the sun shines on the ground
  REQUIRE(sample.ambient_ground[0] > 0.01F);
  for (const double y : {-1.0, -0.6, -1e-6, 0.0, 0.3, 1.0}) {
    const Number3 n = normalAt(sample, 0.8, std::abs(y));
    const Number3 expected = vectorOf(sample.ambient_ground) * (M_PI * (1.0 - y) / 2.0);
    checkNear(irradianceOf(file.sky, sample, y < 0.0 ? -n : n), expected, 4.0);
  }
}

TEST_CASE("Modes, GreyIsTheSameInEveryChannel") {
  ModesOf modes = randomModes(4, 3, 5);
  for (std::size_t i = 0; i < modes.weight.size(); ++i) modes.weight[i] = modes.weight[i / 3 * 3];
  const Parts colour = partsOf(modes);
  Parts grey = colour;
  grey.day.channels = 1;
  std::vector<float> numbers;
  for (std::size_t i = 0; i < modes.weight.size(); i += 3) numbers.push_back(static_cast<float>(modes.weight[i]));
  grey.day.numbers = DayParts::bytesOf(numbers);
  const Opened files[2] = {Opened(colour), Opened(grey)};
  for (const double time_h : {2.0, 20.0})
    for (const double y : {0.1, -0.9}) {
      const WelkinSkySample sample = files[1].at(time_h);
      const Number3 n = normalAt(sample, 0.4, std::abs(y)) * (y < 0.0 ? -1.0 : 1.0);
      const Number3 e = irradianceOf(files[1].sky, sample, n);
      CHECK(e == irradianceOf(files[0].sky, files[0].at(time_h), n));
      CHECK((e.x == e.y && e.y == e.z && e.x > 0.0));
    }
}

TEST_CASE("Modes, BlendsWithOtherSkiesHaveNone") {
  const Opened five(partsOf(randomModes(5, 3, 3)));
  const Opened four(partsOf(randomModes(4, 3, 3)));
  Parts plain_parts;
  const Opened plain(plain_parts);
  const WelkinSkySample a = five.at(3.0);
  const WelkinSkySample b = plain.at(3.0);
  CHECK(b.mode_count == 0);
  const float normal[3] = {0.6F, 0.0F, 0.8F};
  float e[3], of_sample[3];
  CHECK(welkin_sky_irradiance(four.sky, &a, normal, e) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_sky_irradiance(plain.sky, &a, normal, e) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_sky_irradiance(nullptr, &a, normal, e) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_sky_irradiance(five.sky, &a, normal, nullptr) == WELKIN_ERROR_ARGUMENT);
  WelkinSkySample blended{};
  REQUIRE(welkin_sample_blend(&a, &b, 0.25F, &blended) == WELKIN_OK);
  CHECK(blended.mode_count == 0);
  CHECK(std::all_of(&blended.mode_weight[0][0], &blended.mode_weight[0][0] + 3 * WELKIN_MAX_MODES,
                    [](float w) { return w == 0.0F; }));
  REQUIRE(welkin_sample_irradiance(&blended, normal, of_sample) == WELKIN_OK);
  for (const WelkinSky* sky : {five.sky, plain.sky}) {
    REQUIRE(welkin_sky_irradiance(sky, &blended, normal, e) == WELKIN_OK);
    CHECK(std::equal(e, e + 3, of_sample));
  }
}

/// Another sky of the same modes: other weights, intensity and ground.
Parts stormOf(Parts parts) {
  std::vector<float> numbers(parts.day.numbers.size() / sizeof(float));
  std::memcpy(numbers.data(), parts.day.numbers.data(), parts.day.numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] *= i % 3 == 0 ? 0.25F : -0.5F;
  for (std::size_t i = 0; i < numbers.size(); i += parts.day.rows * std::size_t{3}) numbers[i] += 3.0F;
  parts.day.numbers = DayParts::bytesOf(numbers);
  parts.albedo = format::Rgb(0.1F, 0.2F, 0.3F);
  return parts;
}

TEST_CASE("Modes, BlendOfAFamilyIsTheBlendOfItsIrradiances") {
  for (const std::uint8_t count : {3, 8, 12}) {
    const Parts clear = partsOf(randomModes(count, 5, 4));
    const Opened first(clear), second(stormOf(clear));
    const WelkinSkySample a = first.at(9.0), b = second.at(9.0);
    REQUIRE(a.mode_family != 0);
    CHECK(a.mode_family == b.mode_family);
    for (const float weight : {0.0F, 0.25F, 0.7F, 1.0F}) {
      WelkinSkySample blended{};
      REQUIRE(welkin_sample_blend(&a, &b, weight, &blended) == WELKIN_OK);
      CHECK(blended.mode_count == count);
      CHECK(blended.mode_family == a.mode_family);
      for (const double y : {-1.0, -0.4, 0.0, 0.2, 0.9})
        for (const double azimuth : {0.0, 1.2, 2.9}) {
          const Number3 n = normalAt(a, azimuth, std::abs(y)) * (y < 0.0 ? -1.0 : 1.0);
          const Number3 one = irradianceOf(first.sky, a, n), other = irradianceOf(second.sky, b, n);
          if (std::min({one.x, one.y, one.z, other.x, other.y, other.z}) <= 0.0) continue;  // clamped at 0
          const Number3 want = mix(one, other, double{weight});
          for (const WelkinSky* sky : {first.sky, second.sky}) checkNear(irradianceOf(sky, blended, n), want, 40.0);
        }
      WelkinSkyConstants constants{}, of_first{};
      REQUIRE(welkin_sky_constants(first.sky, &a, &constants, sizeof constants) == WELKIN_OK);
      of_first = constants;
      REQUIRE(welkin_sample_ambient_constants(&blended, &constants, sizeof constants) == WELKIN_OK);
      CHECK(constants.mode_weight[0].y == blended.mode_weight[1][0]);
      CHECK(constants.mode_weight[2].x == blended.mode_weight[0][2]);
      CHECK(std::memcmp(&constants.mode_frame, &of_first.mode_frame, sizeof constants.mode_frame) == 0);
    }
  }
}

TEST_CASE("Modes, OnlyTheSameModesAboutTheSameAzimuthBlend") {
  const Parts clear = partsOf(randomModes(5, 5, 4));
  const Opened first(clear), second(stormOf(clear));
  const WelkinSkySample a = first.at(9.0), b = second.at(9.0);
  const auto modesOfBlend = [&](const WelkinSkySample& other) {
    WelkinSkySample blended{};
    REQUIRE(welkin_sample_blend(&a, &other, 0.5F, &blended) == WELKIN_OK);
    CHECK((blended.mode_count == 0) == (blended.mode_family == 0));
    return blended.mode_count;
  };
  CHECK(modesOfBlend(b) == 5);
  CHECK(modesOfBlend(second.at(9.5)) == 0);  // the modes stand about the sun's azimuth
  Parts parts = stormOf(clear);
  parts.day.mode_texels[7] ^= 1;
  const Opened other_map(parts);
  CHECK(modesOfBlend(other_map.at(9.0)) == 0);
  parts = stormOf(clear);
  parts.day.mode_sh[2] += 0.25F;
  CHECK(modesOfBlend(Opened(parts).at(9.0)) == 0);
  WelkinSkySample old = b;  // of a program that does not know the field
  old.struct_size = offsetof(WelkinSkySample, mode_family);
  CHECK(modesOfBlend(old) == 0);

  const float normal[3] = {0.6F, 0.0F, 0.8F};
  float e[3];
  CHECK(welkin_sky_irradiance(other_map.sky, &a, normal, e) == WELKIN_ERROR_ARGUMENT);
  CHECK_THAT(welkin_argument_error(), Catch::Contains("another sky"));
  WelkinSkyConstants constants{};
  CHECK(welkin_sky_constants(other_map.sky, &a, &constants, sizeof constants) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_sky_irradiance(second.sky, &a, normal, e) == WELKIN_OK);
  old = a;
  old.struct_size = offsetof(WelkinSkySample, mode_family);
  CHECK(welkin_sky_irradiance(first.sky, &old, normal, e) == WELKIN_OK);
  WelkinModes modes{};
  REQUIRE(welkin_sky_modes(second.sky, &modes) == WELKIN_OK);
  CHECK(modes.family == a.mode_family);
}

TEST_CASE("Modes, FilterOfEightBits") {
  // The bound in modes.glsl for a device whose filter weights have b bits: the error is at most 2^-b times the sum of
  // the differences to the next column and row. If the weights are truncated, it reaches four fifths of that.
  constexpr double kBits = 256.0;
  std::mt19937 random(23);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  double worst = 0.0;
  for (int i = 0; i < 100000; ++i) {
    const double texel[4] = {unit(random), unit(random), unit(random), unit(random)};  // by row, then column
    const double x = unit(random);
    const double y = unit(random);
    const auto filtered = [&](double across, double upwards) {
      return (1.0 - upwards) * ((1.0 - across) * texel[0] + across * texel[1]) +
             upwards * ((1.0 - across) * texel[2] + across * texel[3]);
    };
    const double columns = std::max(std::abs(texel[1] - texel[0]), std::abs(texel[3] - texel[2]));
    const double rows = std::max(std::abs(texel[2] - texel[0]), std::abs(texel[3] - texel[1]));
    const double cut = filtered(std::floor(x * kBits) / kBits, std::floor(y * kBits) / kBits);
    worst = std::max(worst, std::abs(cut - filtered(x, y)) / ((columns + rows) / kBits));
  }
  CHECK(worst < 1.0);
  CHECK(1.2 * worst > 1.0);
}

}  // namespace welkin::tests
