// SPDX-License-Identifier: Apache-2.0
// FlatBuffers of a sky made part by part, so that a test can omit or break one.
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

#include "format/container.h"

namespace welkin::tests {

struct CurveParts {
  std::uint8_t components = 1;
  std::vector<double> time_h = {0.0}, value = {1.0};
  bool there = true;
};

struct LightParts {
  double latitude = 0.3, declination = 0.4, transit = 12.0, north = 0.0, disc = 0.005;
  std::vector<double> time_h, azimuth, elevation;
  CurveParts illuminance, colour = {3, {0.0}, {1.0, 0.9, 0.8}};
  bool there = true, has_path = true;
};

struct GradientParts {
  std::uint32_t width = 1, height = 2;
  std::vector<float> rgb = std::vector<float>(6, 0.5F);  // empty: left out
  std::vector<std::uint32_t> rgb9e5;                     // empty: left out
  bool there = true;
};

/// Three coefficients and the horizontal irradiance, for a ground that is not black.
struct DayParts {
  std::uint8_t bands = 2, channels = 3, rows = 4, encoding = 0;
  std::vector<double> key_time_h = {0.0, 12.0};
  std::vector<std::uint8_t> numbers = bytesOf(std::vector<float>(24, 0.5F));
  std::vector<float> key_scale, row_scale;
  std::uint8_t mode_count = 0;  ///< 0: no modes
  std::uint16_t mode_columns = 2, mode_rows = 3;
  std::vector<std::uint16_t> mode_texels;
  std::vector<float> mode_sh;
  bool there = true;

  template <typename T>
  static std::vector<std::uint8_t> bytesOf(const std::vector<T>& values) {
    std::vector<std::uint8_t> bytes(values.size() * sizeof(T));
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
  }
};

/// A valid file with two keys, two bands and two cubemaps. Tests break one part of it.
struct Parts {
  double model[6] = {-1.0, -0.3, 10.0, -3.0, 0.45, 0.0};
  std::uint8_t normalise = 0;
  bool has_luminance = true, has_albedo = true, has_settings = true, has_sky = true;
  double unit = 1.0, delta = 1e-4;
  format::Rgb albedo{0.1F, 0.1F, 0.1F};
  CurveParts intensity{1, {0.0, 12.0}, {1.0, 2.0}}, saturation, tint{3, {0.0}, {1.0, 1.0, 1.0}};
  LightParts sun, moon{0, 0, 0, 0, 0.005, {0.0, 12.0}, {0.0, 3.0}, {-1.0, 1.0}, {}, {3, {0.0}, {1, 1, 1}}, true, true};
  GradientParts gradient_sun, gradient_anti;
  DayParts day;
  std::uint32_t cubemap_size = 1;
  std::vector<double> cubemap_time_h = {6.0, 18.0};
  std::vector<std::uint16_t> cubemap = std::vector<std::uint16_t>(24, 0x3c00);
  std::uint8_t cubemap_format = 0;
  bool has_texels = true;
  bool shares_texels = false;  ///< all cubemaps share one picture
};

/// The valid file's table in another encoding: 1 float16, 2 fixed16, 3 fixed8.
DayParts withEncoding(std::uint8_t encoding);

/// A table of `count` modes, valid when `count` is its number of rows, 4.
DayParts withModes(std::uint8_t count);

/// The FlatBuffer, without the container's header.
std::vector<std::uint8_t> payloadOf(const Parts& parts);

}  // namespace welkin::tests
