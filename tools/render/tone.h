// SPDX-License-Identifier: Apache-2.0
// From radiance to 8-bit sRGB: exposure, filmic curve, encoding, dither.
#pragma once

#include <cstdint>
#include <span>
#include <vector>
#include <welkin/welkin.hpp>

#include "render/offscreen.h"

namespace welkin::render {

/// An sRGB-encoded picture: rows from the top, three bytes per pixel.
struct Picture {
  uint32_t width = 0;
  uint32_t height = 0;
  std::vector<uint8_t> rgb;
};

/// Log-average luminance over the pixels that are not black (Reinhard et al., "Photographic Tone Reproduction for
/// Digital Images", SIGGRAPH 2002, eq. 1); 0 when all are black.
double logAverageLuminance(std::span<const FloatImage> images);

/// Luminance of the irradiance, pi included, of a surface that faces up, without sun and moon.
double openGround(const WelkinSkySample& sample);

/// The cosine-weighted mean of the sky's luminance over the upper hemisphere, at the day's brightest quarter hour.
double brightestLuminance(const Sky& sky);

/// Factor that maps `luminance`, a picture's log-average, towards middle grey, 0.18. `day_luminance` is the log-average
/// of the day's brightest instant, which maps to 0.18 exactly. A darker picture is brightened by only four fifths of
/// the stops it lacks, so night stays darker than day. Below 1e-4 of the day the factor stays the same. When both are 0
/// it is 1.
double automaticExposure(double luminance, double day_luminance);

/// The filmic curve by Narkowicz, "ACES Filmic Tone Mapping Curve" (2016): a rational fit, for a channel x >= 0.
double filmic(double x);

/// Exposes, maps, encodes and rounds, with an 8 x 8 ordered dither of half a step (Bayer 1973) against banding of
/// skies. Pure black stays black. Every pixel is the mean of `samples` x `samples` pixels of the image, whose sides are
/// multiples of `samples`. The mean is taken after the filmic curve, so that edges against the sun are as soft as
/// others.
Picture tonemap(const FloatImage& image, double exposure, uint32_t samples = 1);

/// Encodes values in [0, 1] as they are: without exposure, curve or dither. Every pixel is the mean of `samples` x
/// `samples` pixels, as above.
Picture encode(const FloatImage& image, uint32_t samples = 1);

}  // namespace welkin::render
