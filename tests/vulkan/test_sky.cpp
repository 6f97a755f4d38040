// SPDX-License-Identifier: Apache-2.0
// Writes the test sky through the format's own schema.
#include "test_sky.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <random>

#include "format/container.h"

namespace welkin::tests {
namespace {

using flatbuffers::FlatBufferBuilder;
using flatbuffers::Offset;

Offset<format::Curve> curve(FlatBufferBuilder& builder, uint8_t components, const std::vector<double>& time_h,
                            const std::vector<double>& value) {
  return format::CreateCurveDirect(builder, components, &time_h, &value);
}

Offset<format::Gradient> gradient(FlatBufferBuilder& builder, std::mt19937& random, uint32_t width, uint32_t height) {
  std::uniform_real_distribution<float> uniform(0.05F, 1.0F);
  std::vector<float> rgb(std::size_t{3} * width * height);
  for (float& v : rgb) v = uniform(random);
  for (int i = 0; i < 3; ++i) rgb[static_cast<std::size_t>(3 + i)] = 0.0F;  // a black texel, which is neutral
  return format::CreateGradientDirect(builder, width, height, &rgb);
}

Offset<format::Light> sun(FlatBufferBuilder& builder, double disc_radius_rad) {
  const auto path = format::CreateLightPath(builder, 0.3, 0.41, 12.3, 0.2);
  const auto illuminance = curve(builder, 1, {6.0, 12.0, 18.0}, {0.0, 3.0, 0.0});
  const auto colour = curve(builder, 3, {0.0}, {1.0, 0.9, 0.7});
  return format::CreateLight(builder, path, illuminance, colour, disc_radius_rad);
}

Offset<format::Light> moon(FlatBufferBuilder& builder, double disc_radius_rad) {
  const std::vector<double> times{2.0, 14.0};
  const std::vector<double> azimuth{1.0, 4.0};
  const std::vector<double> elevation{0.7, -0.6};
  const auto path = format::CreateLightPathDirect(builder, 0.0, 0.0, 0.0, 0.0, &times, &azimuth, &elevation);
  const auto illuminance = curve(builder, 1, {0.0}, {0.02});
  const auto colour = curve(builder, 3, {0.0}, {0.6, 0.8, 1.0});
  return format::CreateLight(builder, path, illuminance, colour, disc_radius_rad);
}

/// Noise between 1/8 and 2, different in every texel, so that a wrong face, turn or mirror shows.
Offset<format::Cubemap> cubemap(FlatBufferBuilder& builder, std::mt19937& random, double time_h,
                                format::CubemapFormat texel_format) {
  std::uniform_int_distribution<uint16_t> steps(0, 4096);  // 1024 per octave
  const std::size_t texel = format::texelBytes(texel_format);
  std::vector<uint8_t> bytes(std::size_t{6} * kCubemapSize * kCubemapSize * texel);
  for (std::size_t at = 0; at < bytes.size(); at += texel) {
    float rgb[3];
    for (float& v : rgb) {
      const int step = steps(random);
      v = std::ldexp(1.0F + static_cast<float>(step % 1024) / 1024.0F, step / 1024 - 3);
    }
    REQUIRE(format::encodeTexel(texel_format, rgb, bytes.data() + at) == 0);
  }
  builder.ForceVectorAlignment(bytes.size(), 1, 16);
  return format::CreateCubemapDirect(builder, time_h, &bytes);
}

/// The first mode is between 2 and 4. The others are between 1/8 and 1, of either sign: noise without any symmetry.
Offset<format::Modes> modes(FlatBufferBuilder& builder, std::mt19937& random, uint8_t count) {
  std::uniform_int_distribution<uint16_t> strong(0x4000, 0x4400), weak(0x3000, 0x3c00), sign(0, 1);
  std::vector<uint16_t> texels(std::size_t{count} * kModeColumns * kModeRows);
  for (std::size_t i = 0; i < texels.size(); ++i)
    texels[i] = i % count == 0 ? strong(random) : static_cast<uint16_t>(weak(random) | sign(random) << 15);
  std::uniform_real_distribution<float> uniform(-0.5F, 0.5F);
  std::vector<float> polar_sh(std::size_t{count} * 15);
  for (float& v : polar_sh) v = uniform(random);
  return format::CreateModesDirect(builder, count, kModeColumns, kModeRows, &texels, &polar_sh);
}

/// Three keys of 15 coefficients and the horizontal irradiance, or of the weights of modes.
Offset<format::Day> day(FlatBufferBuilder& builder, std::mt19937& random, uint8_t mode_count, unsigned seed) {
  const std::vector<double> key_time_h{1.0, 9.0, 16.0};
  const uint8_t rows = mode_count > 0 ? mode_count : 16;
  std::uniform_real_distribution<float> uniform(-0.3F, 0.3F);
  std::mt19937 of_day(seed);
  std::vector<float> numbers;
  for (std::size_t i = 0; i < key_time_h.size() * rows * 3; ++i) {
    const std::size_t row = i / 3 % rows;
    const float middle = mode_count > 0 ? (row == 0 ? 1.0F : 0.0F) : row == 0 ? 2.0F : row == 15 ? 1.5F : 0.0F;
    const float usual = uniform(random), own = uniform(of_day);
    numbers.push_back(middle + (seed == 0 ? usual : own));
  }
  std::vector<uint8_t> bytes(numbers.size() * sizeof(float));
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  const auto of_modes = mode_count > 0 ? modes(builder, random, mode_count) : Offset<format::Modes>();
  builder.ForceVectorAlignment(bytes.size(), 1, 16);
  return format::CreateDayDirect(builder, 5, 3, &key_time_h, rows, format::Encoding::float32, &bytes, nullptr, nullptr,
                                 of_modes);
}

}  // namespace

std::vector<std::byte> testSkyFile(const TestSkyOptions& options) {
  std::mt19937 random(7);  // The C++ standard fixes its sequence.
  FlatBufferBuilder builder;
  const format::Luminance luminance(-1.0, -0.08, 24.0, -3.0, 0.3, 0.0, options.normalise_to_sun ? 1 : 0);
  const format::Rgb ground_albedo(0.2F, 0.3F, 0.1F);
  const auto day_table = day(builder, random, options.mode_count, options.day);
  std::vector<Offset<format::Cubemap>> cubemaps;
  if (options.cubemaps)
    for (const double time_h : {3.0, 11.0, 20.0})
      cubemaps.push_back(cubemap(builder, random, time_h, options.cubemap_format));
  const auto intensity = curve(builder, 1, {0.0, 6.0, 12.0, 18.0}, {0.001, 0.3, 1.0, 0.4});
  const auto saturation = curve(builder, 1, {0.0}, {0.8});
  const auto tint = curve(builder, 3, {0.0, 12.0}, {0.9, 1.0, 1.1, 1.05, 0.95, 0.8});
  const auto sun_light = sun(builder, options.disc_radius_rad);
  const auto moon_light = moon(builder, options.disc_radius_rad);
  const auto gradient_sun = gradient(builder, random, 5, 4);
  const auto gradient_anti = gradient(builder, random, 7, 3);
  const auto cubemap_vector = builder.CreateVector(cubemaps);
  format::SkyBuilder sky(builder);
  sky.add_luminance(&luminance);
  sky.add_luminance_unit(1.0);
  sky.add_ground_albedo(&ground_albedo);
  sky.add_intensity(intensity);
  sky.add_ambient_saturation(saturation);
  sky.add_polarising_tint(tint);
  sky.add_sun(sun_light);
  sky.add_moon(moon_light);
  sky.add_gradient_sun(gradient_sun);
  sky.add_gradient_anti(gradient_anti);
  sky.add_gradient_delta(1e-4);
  sky.add_day(day_table);
  sky.add_cubemap_size(options.cubemaps ? kCubemapSize : 0);
  sky.add_cubemaps(cubemap_vector);
  sky.add_cubemap_format(static_cast<uint8_t>(options.cubemap_format));
  const auto finished = sky.Finish();
  builder.Finish(format::CreateFile(builder, builder.CreateString("{}"), 0, finished));
  return format::seal({builder.GetBufferPointer(), builder.GetSize()});
}

Sky openTestSky(const std::vector<std::byte>& bytes) {
  Sky sky;
  const Status status = sky.open(bytes.data(), bytes.size());
  INFO(status.message);
  REQUIRE(status);
  return sky;
}

}  // namespace welkin::tests
