// SPDX-License-Identifier: Apache-2.0
// Packs the sample of a sky into the uniform block of the shaders.
#pragma once

#include <welkin/sky_constants.h>
#include <welkin/welkin.h>

namespace welkin::core {

/// The constants that belong to the sky and not to the hour.
struct SkyShape {
  WelkinLuminance luminance{};
  uint32_t gradient_size[4]{};  ///< columns and rows of the sun's gradient, then of the opposite one
  float gradient_delta = 0.0F;
  WelkinStars stars{};  ///< without its texels
  WelkinModes modes{};  ///< without its texels
};

/// Column left of the hour in [0, 24), and the weight of the next one; columns wrap. In double: the hour as a float
/// would move a gradient by 1e-6 h.
struct GradientColumn {
  float left;
  float weight;
};
GradientColumn gradientColumnAt(double time_h, uint32_t width);

/// The shape of an opened sky. WELKIN_ERROR_ARGUMENT if it is null.
WelkinResult shapeOf(const WelkinSky* sky, SkyShape& shape);

/// Packs the uniform block. `sample` comes from welkin_sky_sample.
WelkinSkyConstants packConstants(const SkyShape& shape, const WelkinSkySample& sample);

/// Packs the ambient light alone: the coefficients, their number, and the weights of the modes. For a sample without
/// modes, such as a cross-blend, modes.glsl gets the light of the first two bands.
void packAmbient(const WelkinSkySample& sample, WelkinSkyConstants& constants);

/// Writes the ambient light of a cross-blend over that of the uniform block at `block`. It reads nothing there: mapped
/// device memory is slow to read.
void replaceAmbient(const WelkinSkySample& blended, unsigned char* block);

}  // namespace welkin::core
