// SPDX-License-Identifier: Apache-2.0
// Packs the sample of a sky into the uniform block of the shaders.
#include "core/constants.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/arguments.h"
#include "shared.h"

namespace welkin::core {
namespace {

WelkinFloat4 pack(const float v[3], float w) {
  return {v[0], v[1], v[2], w};
}

/// Nearest float; values near the end of float's range become 1e38, so that a shader can still add them.
float packed(double value) {
  return static_cast<float>(std::clamp(value, -1e38, 1e38));
}

/// Radiance E / (pi sin^2 r) and radius r of a light's disc; all 0 without one. r is in (0, pi/2].
WelkinFloat4 discOf(const WelkinLight& light) {
  const double sine = std::sin(double{light.disc_radius_rad});
  if (!(sine > 0.0)) return {};
  const double scale = 1.0 / (f64::kPi * sine * sine);
  float radiance[3];
  for (int i = 0; i < 3; ++i) radiance[i] = packed(double{light.normal_irradiance[i]} * scale);
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
    constants.mode_rest[c] = {packed(axis[0][c]), packed(axis[1][c]), packed(axis[2][c]), packed(rest)};
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

WelkinResult shapeOf(const WelkinSky* sky, SkyShape& shape) {
  WelkinGradients gradients{};
  if (welkin_sky_gradients(sky, &gradients) != WELKIN_OK || welkin_sky_stars(sky, &shape.stars) != WELKIN_OK ||
      welkin_sky_modes(sky, &shape.modes) != WELKIN_OK || welkin_sky_luminance(sky, &shape.luminance) != WELKIN_OK)
    return WELKIN_ERROR_ARGUMENT;
  const uint32_t sizes[4] = {gradients.sun.width, gradients.sun.height, gradients.anti.width, gradients.anti.height};
  std::memcpy(shape.gradient_size, sizes, sizeof(sizes));
  shape.gradient_delta = gradients.delta;
  shape.stars.rgba8 = nullptr;  // the sky may be closed before the shape is used
  shape.modes.texels = nullptr;
  return WELKIN_OK;
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

void replaceAmbient(const WelkinSkySample& blended, unsigned char* block) {
  WelkinSkyConstants constants{};
  packAmbient(blended, constants);
  std::memcpy(block + offsetof(WelkinSkyConstants, moon) + offsetof(WelkinFloat4, w), &constants.moon.w, sizeof(float));
  constexpr size_t kFirst = offsetof(WelkinSkyConstants, ambient_sh);  // up to mode_texels, fixed for all hours
  std::memcpy(block + kFirst, constants.ambient_sh, offsetof(WelkinSkyConstants, mode_texels) - kFirst);
}

}  // namespace welkin::core

namespace {

using namespace welkin::core;

constexpr size_t kFirstBlock = 832;  // bytes of the block in the first release

WelkinResult checkBlock(const char* function, const WelkinSkyConstants* constants, size_t size) {
  if (const auto r = nonNull(function, {{"constants", constants}})) return r;
  if (size >= kFirstBlock && size <= sizeof(WelkinSkyConstants) && size % sizeof(WelkinFloat4) == 0) return WELKIN_OK;
  return refuse(function, "size is %zu, must be a multiple of 16 from %zu to %zu", size, kFirstBlock,
                sizeof(WelkinSkyConstants));
}

}  // namespace

WelkinResult welkin_sky_constants(const WelkinSky* sky, const WelkinSkySample* sample, WelkinSkyConstants* constants,
                                  size_t size) {
  if (const auto r = nonNull(__func__, {{"sky", sky}})) return r;
  if (const auto r = checkSample(__func__, "sample", sample)) return r;
  if (const auto r = checkBlock(__func__, constants, size)) return r;
  SkyShape shape;
  if (const auto r = shapeOf(sky, shape)) return r;
  if (const auto r = checkModes(__func__, "sample", *sample, shape.modes.count, shape.modes.family)) return r;
  const WelkinSkyConstants packed_block = packConstants(shape, *sample);
  std::memcpy(constants, &packed_block, size);
  return WELKIN_OK;
}

WelkinResult welkin_sample_ambient_constants(const WelkinSkySample* blended, WelkinSkyConstants* constants,
                                             size_t size) {
  if (const auto r = checkSample(__func__, "blended", blended)) return r;
  if (const auto r = checkBlock(__func__, constants, size)) return r;
  replaceAmbient(*blended, reinterpret_cast<unsigned char*>(constants));
  return WELKIN_OK;
}
