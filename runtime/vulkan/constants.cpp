// SPDX-License-Identifier: Apache-2.0
// Packs the sample of a sky into the uniform block of the shaders.
#include "vulkan/constants.h"

#include <algorithm>
#include <cmath>

#include "shared.h"

namespace welkin::vulkan {
namespace {

WelkinFloat4 pack(const float v[3], float w) {
  return {v[0], v[1], v[2], w};
}

/// Nearest float; values past float's range stay finite.
float toFloat(double value) {
  return static_cast<float>(std::clamp(value, -1e38, 1e38));
}

/// Radiance E / (pi sin^2 r) and radius r of a light's disc; all 0 without one. r is in (0, pi/2].
WelkinFloat4 discOf(const WelkinLight& light) {
  const double sine = std::sin(double{light.disc_radius_rad});
  if (!(sine > 0.0)) return {};
  const double scale = 1.0 / (f64::kPi * sine * sine);
  float radiance[3];
  for (int i = 0; i < 3; ++i) radiance[i] = toFloat(double{light.normal_irradiance[i]} * scale);
  return pack(radiance, light.disc_radius_rad);
}

/// Scale and offset that take coordinates 0 and 1 to the centres of the first and the last of `texels` texels.
float texelScale(uint32_t texels) {
  return texels == 0 ? 0.0F : static_cast<float>((texels - 1.0) / texels);
}
float texelOffset(uint32_t texels) {
  return texels == 0 ? 0.0F : static_cast<float>(0.5 / texels);
}

/// Packs the terms from which modes.glsl sums E: the weights of the modes; V for lower normals; and the ground's share.
/// Without modes they are the first two bands of the coefficients.
void packModes(const WelkinSkySample& sample, WelkinSkyConstants& constants) {
  const auto sh = [&](int i) {
    return f64::Number3(double{sample.ambient_sh[i][0]}, double{sample.ambient_sh[i][1]},
                        double{sample.ambient_sh[i][2]});
  };
  const bool has_modes = sample.mode_count > 0;
  const double linear = has_modes ? 1.0 : f64::cosineLobe(1) * f64::kShLinear * f64::kShLinear;
  const double constant = f64::cosineLobe(0) * f64::kShConstant;
  f64::Number3 axis[3];
  for (int i = 0; i < 3; ++i) {
    f64::Number3 normal(0.0);
    normal[i] = linear;
    axis[i] = f64::excessIrradiance(normal, sh(1), sh(2), sh(3));
  }
  for (int c = 0; c < 3; ++c) {
    const double rest = has_modes ? double{sample.ambient_ground[c]} * f64::groundIrradiance(0.0) : constant * sh(0)[c];
    constants.mode_rest[c] = {toFloat(axis[0][c]), toFloat(axis[1][c]), toFloat(axis[2][c]), toFloat(rest)};
    for (int set = 0; set < WELKIN_MAX_MODES / 4; ++set) {
      const auto weight = [&](int k) { return sample.mode_weight[4 * set + k][c]; };
      constants.mode_weight[3 * set + c] = {weight(0), weight(1), weight(2), weight(3)};
    }
  }
  constants.mode_frame = {sample.mode_azimuth[0], sample.mode_azimuth[1], has_modes ? 0.0F : 1.0F,
                          has_modes ? 1.0F : 0.0F};
}

}  // namespace

GradientColumn gradientColumnAt(double time_h, uint32_t width) {
  const double column = f64::gradientColumn(time_h, double{static_cast<double>(width)});
  const double left = std::floor(column);
  const double wrapped = left < 0.0 ? left + static_cast<double>(width) : left;
  return {static_cast<float>(wrapped), static_cast<float>(column - left)};
}

WelkinSkyConstants packConstants(const SkyShape& shape, const WelkinSkySample& sample) {
  const auto& l = shape.luminance;
  const auto* size = shape.gradient_size;
  const GradientColumn sun = gradientColumnAt(sample.time_h, size[0]);
  const GradientColumn anti = gradientColumnAt(sample.time_h, size[2]);
  WelkinSkyConstants c{};
  c.sun = pack(sample.sun.direction, static_cast<float>(sample.time_h));
  c.luminance_abcd = {l.a, l.b, l.c, l.d};
  c.luminance_ek = {l.e, l.k, sample.luminance_norm, sample.intensity};
  c.tint = pack(sample.polarising_tint, shape.gradient_delta);
  c.ground = pack(sample.ground_radiance, sample.cubemap_weight);
  c.gradient_size = {static_cast<float>(size[0]), static_cast<float>(size[1]), static_cast<float>(size[2]),
                     static_cast<float>(size[3])};
  c.gradient_column = {sun.left, sun.weight, anti.left, anti.weight};
  c.sun_disc = discOf(sample.sun);
  c.moon = pack(sample.moon.direction, 0.0F);
  c.moon_disc = discOf(sample.moon);
  const double turn = f64::kTwoPi * (sample.time_h - shape.stars.midnight_h) / 24.0;
  c.stars = {shape.stars.latitude_rad, shape.stars.north_offset_rad, static_cast<float>(turn), shape.stars.intensity};
  WelkinLight key{};
  welkin_sample_key_light(&sample, &key);
  c.key_direction = pack(key.direction, 0.0F);
  c.key_irradiance = pack(key.normal_irradiance, 0.0F);
  packAmbient(sample, c);
  c.mode_texels = {texelScale(shape.modes.columns), texelScale(shape.modes.rows), texelOffset(shape.modes.columns),
                   texelOffset(shape.modes.rows)};
  return c;
}

void packAmbient(const WelkinSkySample& sample, WelkinSkyConstants& constants) {
  constants.moon.w = static_cast<float>(sample.coefficient_count);
  for (uint32_t i = 0; i < sample.coefficient_count; ++i) constants.ambient_sh[i] = pack(sample.ambient_sh[i], 0.0F);
  packModes(sample, constants);
}

}  // namespace welkin::vulkan
