// SPDX-License-Identifier: Apache-2.0
// Files with a right checksum and wrong content, as from a faulty writer or an attacker. They are refused with
// WELKIN_ERROR_CONTENT, or they are harmless.
#include <welkin/welkin.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "forge.h"
#include "format/container.h"

using namespace welkin;
using namespace welkin::tests;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Calls everything that a game may ask of an open sky. Returns whether every number was finite.
bool use(const WelkinSky* sky) {
  double sum = 0.0;
  WelkinSkyInfo info;
  REQUIRE(welkin_sky_info(sky, &info) == WELKIN_OK);
  const char* settings = nullptr;
  REQUIRE(welkin_sky_settings(sky, &settings) == WELKIN_OK);
  sum += static_cast<double>(std::strlen(settings));
  for (std::uint32_t i = 0; i < info.cubemap_count; ++i) {
    WelkinCubemap cubemap;
    REQUIRE(welkin_sky_cubemap(sky, i, &cubemap) == WELKIN_OK);
    const auto* texels = static_cast<const unsigned char*>(cubemap.texels);
    sum += texels[0] + texels[cubemap.bytes - 1];
  }
  for (const double time : {0.0, 7.3, 23.99}) {
    WelkinSkySample s;
    REQUIRE(welkin_sky_sample(sky, time, &s) == WELKIN_OK);
    const float directions[3][3] = {{0, 1, 0}, {1, 0, 0}, {0.6F, 0.8F, 0}};
    for (const auto& direction : directions) {
      float rgb[3];
      REQUIRE(welkin_sample_irradiance(&s, direction, rgb) == WELKIN_OK);
      sum += double{rgb[0]} + double{rgb[1]} + double{rgb[2]};
      REQUIRE(welkin_sky_irradiance(sky, &s, direction, rgb) == WELKIN_OK);
      sum += double{rgb[0]} + double{rgb[1]} + double{rgb[2]};
      REQUIRE(welkin_dome_radiance(sky, &s, direction, rgb) == WELKIN_OK);
    }
    for (const WelkinLight& light : {s.sun, s.moon})
      for (int c = 0; c < 3; ++c) sum += double{light.direction[c]} + double{light.normal_irradiance[c]};
  }
  return std::isfinite(sum);
}

struct Opened {
  WelkinResult result;
  std::string message;
  bool finite = true;
};

Opened open(const std::vector<std::uint8_t>& payload) {
  const auto bytes = format::seal(payload);
  WelkinSky* sky = nullptr;
  WelkinMessage message{};
  Opened opened{welkin_sky_open_memory(bytes.data(), bytes.size(), &sky, &message), message.text};
  REQUIRE((opened.result == WELKIN_OK) == (sky != nullptr));
  if (sky != nullptr) opened.finite = use(sky);
  welkin_sky_close(sky);
  return opened;
}

struct Case {
  const char* said;
  std::function<void(Parts&)> spoil;
};

void requireRefused(const std::vector<Case>& cases) {
  int number = 0;
  for (const Case& c : cases) {
    Parts parts;
    c.spoil(parts);
    const Opened opened = open(payloadOf(parts));
    INFO("case " << number++ << ", " << c.said << ": " << opened.message);
    REQUIRE(opened.result == WELKIN_ERROR_CONTENT);
    REQUIRE(opened.message.find(c.said) == 0);
  }
}

}  // namespace

TEST_CASE("Content, WholeFileOpens") {
  const Opened opened = open(payloadOf(Parts()));
  INFO(opened.message);
  REQUIRE(opened.result == WELKIN_OK);
  REQUIRE(opened.finite);
  Parts plain;
  plain.moon.there = false;
  plain.cubemap_time_h.clear();
  REQUIRE(open(payloadOf(plain)).result == WELKIN_OK);
  Parts shared;
  shared.gradient_sun.rgb.clear();
  shared.gradient_sun.rgb9e5 = {0x80402010U, 0xffffffffU};
  REQUIRE(open(payloadOf(shared)).result == WELKIN_OK);
  for (const std::uint8_t packed : {1, 2}) {
    Parts parts;
    parts.cubemap_format = packed;
    parts.cubemap.resize(12);
    REQUIRE(open(payloadOf(parts)).result == WELKIN_OK);
  }
}

TEST_CASE("Content, MissingPartsAreRefused") {
  requireRefused({{"sky", [](Parts& p) { p.has_sky = false; }},
                  {"settings", [](Parts& p) { p.has_settings = false; }},
                  {"luminance", [](Parts& p) { p.has_luminance = false; }},
                  {"ground_albedo", [](Parts& p) { p.has_albedo = false; }},
                  {"intensity", [](Parts& p) { p.intensity.there = false; }},
                  {"ambient_saturation", [](Parts& p) { p.saturation.there = false; }},
                  {"polarising_tint", [](Parts& p) { p.tint.there = false; }},
                  {"sun", [](Parts& p) { p.sun.there = false; }},
                  {"sun", [](Parts& p) { p.sun.has_path = false; }},
                  {"moon", [](Parts& p) { p.moon.has_path = false; }},
                  {"sun", [](Parts& p) { p.sun.illuminance.there = false; }},
                  {"moon", [](Parts& p) { p.moon.colour.there = false; }},
                  {"gradient_sun", [](Parts& p) { p.gradient_sun.there = false; }},
                  {"gradient_anti", [](Parts& p) { p.gradient_anti.there = false; }},
                  {"a cubemap", [](Parts& p) { p.has_texels = false; }}});
}

TEST_CASE("Content, VectorsOfTheWrongSizeAreRefused") {
  requireRefused({{"intensity", [](Parts& p) { p.intensity.value.pop_back(); }},
                  {"intensity", [](Parts& p) { p.intensity.components = 3; }},
                  {"intensity",
                   [](Parts& p) {
                     p.intensity = {1, {}, {}};
                   }},
                  {"polarising_tint", [](Parts& p) { p.tint.value.push_back(1.0); }},
                  {"sun",
                   [](Parts& p) {
                     p.sun.colour = {1, {0.0}, {1.0}};
                   }},
                  {"moon", [](Parts& p) { p.moon.azimuth.pop_back(); }},
                  {"moon", [](Parts& p) { p.moon.elevation.push_back(0.0); }},
                  {"gradient_sun", [](Parts& p) { p.gradient_sun.rgb.pop_back(); }},
                  {"gradient_sun", [](Parts& p) { p.gradient_sun.width = 0; }},
                  {"gradient_sun",
                   [](Parts& p) {
                     p.gradient_sun.rgb9e5 = {1, 2};
                   }},
                  {"gradient_sun",
                   [](Parts& p) {
                     p.gradient_sun.rgb.clear();
                     p.gradient_sun.rgb9e5 = {1, 2, 3};
                   }},
                  {"gradient_anti", [](Parts& p) { p.gradient_anti.height = 0xffffffff; }},
                  {"bands", [](Parts& p) { p.day.bands = 1; }},
                  {"bands", [](Parts& p) { p.day.bands = 6; }},
                  {"the day's table", [](Parts& p) { p.day.bands = 3; }},
                  {"the day's table", [](Parts& p) { p.day.numbers.pop_back(); }},
                  {"the day's table", [](Parts& p) { p.day.rows = 3; }},
                  {"the day's table", [](Parts& p) { p.day.key_time_h.clear(); }},
                  {"the day's table", [](Parts& p) { p.day.there = false; }},
                  {"the day's table", [](Parts& p) { p.day.channels = 2; }},
                  {"the day's table", [](Parts& p) { p.day.encoding = 1; }},
                  {"the day's table", [](Parts& p) { p.day.encoding = 4; }},
                  {"the day's table",
                   [](Parts& p) {
                     p.day.key_scale = {1.0F, 1.0F};
                   }},
                  {"the day's table", [](Parts& p) { p.day.row_scale = {1.0F}; }},
                  {"the modes", [](Parts& p) { p.day = withModes(13); }},
                  {"the day's table", [](Parts& p) { p.day = withModes(3); }},
                  {"the modes", [](Parts& p) { p.day = withModes(4), p.day.mode_texels.pop_back(); }},
                  {"the modes", [](Parts& p) { p.day = withModes(4), p.day.mode_sh.push_back(0.0F); }},
                  {"the modes", [](Parts& p) { p.day = withModes(4), p.day.mode_columns = 1; }},
                  {"a cubemap", [](Parts& p) { p.cubemap_size = 2; }},
                  {"a cubemap", [](Parts& p) { p.cubemap_format = 1; }},
                  {"a cubemap",
                   [](Parts& p) {
                     p.cubemap_time_h.clear();
                     for (int i = 0; i < 240; ++i) p.cubemap_time_h.push_back(0.1 * i);
                     p.shares_texels = true;
                   }},
                  {"cubemap_format", [](Parts& p) { p.cubemap_format = 3; }},
                  {"cubemap_format", [](Parts& p) { p.cubemap_time_h.clear(), p.cubemap_format = 3; }},
                  {"cubemap_size", [](Parts& p) { p.cubemap_size = 0; }},
                  {"cubemap_size", [](Parts& p) { p.cubemap_size = 0xffffffff; }}});
}

TEST_CASE("Content, TimesMustAscendWithinTheDay") {
  requireRefused({{"intensity",
                   [](Parts& p) {
                     p.intensity.time_h = {12.0, 0.0};
                   }},
                  {"intensity",
                   [](Parts& p) {
                     p.intensity.time_h = {6.0, 6.0};
                   }},
                  {"intensity",
                   [](Parts& p) {
                     p.intensity.time_h = {0.0, kNan};
                   }},
                  {"intensity",
                   [](Parts& p) {
                     p.intensity.time_h = {0.0, 24.0};
                   }},
                  {"sun", [](Parts& p) { p.sun.illuminance.time_h = {-1.0}; }},
                  {"moon",
                   [](Parts& p) {
                     p.moon.time_h = {12.0, 0.0};
                   }},
                  {"the day's table",
                   [](Parts& p) {
                     p.day.key_time_h = {kNan, 1.0};
                   }},
                  {"the day's table",
                   [](Parts& p) {
                     p.day.key_time_h = {13.0, 12.0};
                   }},
                  {"the cubemaps",
                   [](Parts& p) {
                     p.cubemap_time_h = {18.0, 6.0};
                   }},
                  {"the cubemaps",
                   [](Parts& p) {
                     p.cubemap_time_h = {kNan, 6.0};
                   }},
                  {"the cubemaps", [](Parts& p) {
                     p.cubemap_time_h = {6.0, kInfinity};
                   }}});
}

TEST_CASE("Content, NumbersMustBeFiniteAndInTheirDomain") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  requireRefused({{"luminance", [](Parts& p) { p.model[0] = kNan; }},
                  {"luminance", [](Parts& p) { p.model[1] = 0.0; }},
                  {"luminance", [](Parts& p) { p.model[3] = kInfinity; }},
                  {"luminance", [](Parts& p) { p.model[0] = -2.0; }},
                  {"luminance", [](Parts& p) { p.model[2] = -24.0; }},
                  {"luminance", [](Parts& p) { p.normalise = 2; }},
                  {"luminance_unit", [](Parts& p) { p.unit = 0.0; }},
                  {"luminance_unit", [](Parts& p) { p.unit = kInfinity; }},
                  {"gradient_delta", [](Parts& p) { p.delta = kNan; }},
                  {"ground_albedo", [](Parts& p) { p.albedo = format::Rgb(0.0F, 1.5F, 0.0F); }},
                  {"intensity",
                   [](Parts& p) {
                     p.intensity.value = {kNan, 1.0};
                   }},
                  {"intensity",
                   [](Parts& p) {
                     p.intensity.value = {-1.0, 1.0};
                   }},
                  {"ambient_saturation", [](Parts& p) { p.saturation.value = {1.5}; }},
                  {"polarising_tint", [](Parts& p) { p.tint.value[1] = kInfinity; }},
                  {"sun", [](Parts& p) { p.sun.latitude = 2.0; }},
                  {"sun", [](Parts& p) { p.sun.transit = kNan; }},
                  {"sun", [](Parts& p) { p.sun.disc = -1.0; }},
                  {"sun",
                   [](Parts& p) {
                     p.sun.colour.value = {0.0, 0.0, 0.0};
                   }},
                  {"sun",
                   [](Parts& p) {
                     p.sun.colour.value = {1e-300, 0.0, 0.0};
                   }},
                  {"moon", [](Parts& p) { p.moon.elevation[0] = 2.0; }},
                  {"moon", [](Parts& p) { p.moon.azimuth[0] = kNan; }},
                  {"gradient_sun", [=](Parts& p) { p.gradient_sun.rgb[0] = nan; }},
                  {"gradient_anti", [](Parts& p) { p.gradient_anti.rgb[5] = -1.0F; }},
                  {"the day's table", [=](Parts& p) { std::memcpy(p.day.numbers.data() + 4 * 23, &nan, 4); }},
                  {"the day's table", [](Parts& p) { p.day = withEncoding(2), p.day.key_scale[1] = -1.0F; }},
                  {"the day's table", [=](Parts& p) { p.day = withEncoding(3), p.day.row_scale[11] = nan; }},
                  {"the day's table", [](Parts& p) { p.day = withEncoding(1), p.day.numbers[1] = 0x7c; }},
                  {"the modes", [](Parts& p) { p.day = withModes(4), p.day.mode_texels[23] = 0x7e00; }},
                  {"the modes", [=](Parts& p) { p.day = withModes(4), p.day.mode_sh[0] = nan; }},
                  {"a cubemap", [](Parts& p) { p.cubemap[23] = 0x7e00; }},  // NaN
                  {"a cubemap", [](Parts& p) { p.cubemap[0] = 0x7c00; }},   // infinity
                  {"a cubemap", [](Parts& p) { p.cubemap[5] = 0xbc00; }},   // -1
                  {"a cubemap", [](Parts& p) {
                     p.cubemap_format = 2;
                     p.cubemap.assign(12, 0x3c00);
                     p.cubemap[10] = 0x07c0;  // infinite red
                   }}});
}

TEST_CASE("Content, MisalignedNumbersAreRefused") {
  const auto payload = payloadOf(Parts());
  const auto* curve = format::GetFile(payload.data())->sky()->intensity();
  const auto* table = reinterpret_cast<const std::uint8_t*>(curve);
  const auto field =
      reinterpret_cast<const flatbuffers::Table*>(curve)->GetOptionalFieldOffset(format::Curve::VT_TIME_H);
  REQUIRE(field != 0);
  const auto at = static_cast<std::size_t>(table - payload.data()) + field;
  int tried = 0;
  for (std::size_t target = (at + 8) / 8 * 8; target + 8 < payload.size(); target += 8) {  // elements 4 bytes off
    auto forged = payload;
    const auto offset = static_cast<std::uint32_t>(target - at);
    const std::uint32_t length = 1;
    std::memcpy(forged.data() + at, &offset, sizeof offset);
    std::memcpy(forged.data() + target, &length, sizeof length);
    REQUIRE(open(forged).result == WELKIN_ERROR_CONTENT);
    ++tried;
  }
  REQUIRE(tried > 10);
}

TEST_CASE("Content, RandomDamageUnderARightChecksumNeverCrashes") {
  const auto payload = payloadOf(Parts());
  std::mt19937 random(20121);
  const auto upTo = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
  const double doubles[] = {kNan, kInfinity, -kInfinity, -0.0, 1e-320, 1e30, -1e30, 24.0};
  int opened = 0;
  constexpr int kFiles = 6000;
  for (int i = 0; i < kFiles; ++i) {
    auto forged = payload;
    for (std::size_t n = 1 + upTo(3); n > 0; --n) {
      const std::size_t word = upTo(forged.size() / 8) * 8;
      const std::uint32_t small = static_cast<std::uint32_t>(upTo(64));
      switch (upTo(4)) {
        case 0:
          forged[upTo(forged.size())] = static_cast<std::uint8_t>(random());
          break;
        case 1:
          forged[upTo(forged.size())] ^= static_cast<std::uint8_t>(1U << upTo(8));
          break;
        case 2:
          std::memcpy(forged.data() + word + 4 * upTo(2), &small, sizeof small);
          break;
        default:
          std::memcpy(forged.data() + word, &doubles[upTo(8)], sizeof(double));
      }
    }
    const Opened result = open(forged);
    INFO("file " << i << ": " << result.message);
    REQUIRE((result.result == WELKIN_OK || result.result == WELKIN_ERROR_CONTENT));
    REQUIRE(result.finite);
    opened += result.result == WELKIN_OK ? 1 : 0;
  }
  REQUIRE(opened > kFiles / 20);  // Fewer would prove nothing about sampling.
  REQUIRE(opened < kFiles);
  for (std::size_t size = 0; size < payload.size(); size += 3)
    REQUIRE(open({payload.begin(), payload.begin() + static_cast<std::ptrdiff_t>(size)}).result ==
            WELKIN_ERROR_CONTENT);
}
