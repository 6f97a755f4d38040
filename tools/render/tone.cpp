// SPDX-License-Identifier: Apache-2.0
// Exposure, tone mapping and encoding of pictures.
#include "render/tone.h"

#include <algorithm>
#include <cmath>

#include "shared.h"

namespace welkin::render {
namespace {

constexpr double kMiddleGrey = 0.18;
constexpr double kAdaptation = 0.8;     // Share of the stops between a picture and the day that exposure compensates.
constexpr double kDarkestNight = 1e-4;  // Fraction of the day's luminance; below it the exposure stays.

}  // namespace

double logAverageLuminance(std::span<const FloatImage> images) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const FloatImage& image : images) {
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
      const f64::Number3 rgb{double{image.rgba[i]}, double{image.rgba[i + 1]}, double{image.rgba[i + 2]}};
      const double y = f64::luminanceOf(rgb);
      if (!(y > 0.0) || !std::isfinite(y)) continue;
      sum += std::log(y);
      ++count;
    }
  }
  return count == 0 ? 0.0 : std::exp(sum / static_cast<double>(count));
}

double openGround(const WelkinSkySample& sample) {
  const float up[3] = {0.0F, 1.0F, 0.0F};
  float e[3] = {};
  if (welkin_sample_irradiance(&sample, up, e) != WELKIN_OK) return 0.0;
  return f64::luminanceOf({double{e[0]}, double{e[1]}, double{e[2]}});
}

double brightestLuminance(const Sky& sky) {
  double brightest = 0.0;
  for (int quarter = 0; quarter < 96; ++quarter) {
    WelkinSkySample sample;
    if (sky.sample(quarter / 4.0, sample)) brightest = std::max(brightest, openGround(sample) / f64::kPi);
  }
  return brightest;
}

double automaticExposure(double luminance, double day_luminance) {
  const double day = std::max(luminance, day_luminance);
  if (!(day > 0.0)) return 1.0;
  const double relative = std::max(luminance / day, kDarkestNight);
  return kMiddleGrey / (day * std::pow(relative, kAdaptation));
}

double filmic(double x) {
  const double bounded = std::min(x, 1e6);
  return std::clamp(bounded * (2.51 * bounded + 0.03) / (bounded * (2.43 * bounded + 0.59) + 0.14), 0.0, 1.0);
}

Picture tonemap(const FloatImage& image, double exposure, uint32_t samples) {
  const uint32_t width = image.width / samples;
  const uint32_t height = image.height / samples;
  Picture picture{width, height, std::vector<uint8_t>(std::size_t{3} * width * height)};
  uint8_t* out = picture.rgb.data();
  for (uint32_t y = 0; y < height; ++y) {
    for (uint32_t x = 0; x < width; ++x) {
      for (int channel = 0; channel < 3; ++channel) {
        double sum = 0.0;
        bool black = true;
        for (uint32_t s = 0; s < samples * samples; ++s) {
          const double radiance = double{image.pixel(samples * x + s % samples, samples * y + s / samples)[channel]};
          const double exposed = radiance * exposure;  // NaN becomes black
          sum += filmic(exposed > 0.0 ? exposed : 0.0);
          black = black && !(radiance > 0.0);
        }
        const double code = 255.0 * f64::srgbEncode(sum / (samples * samples));
        const double dithered = black ? code : code + f64::ditherAt(static_cast<int>(x), static_cast<int>(y));
        *out++ = static_cast<uint8_t>(std::clamp(std::floor(dithered + 0.5), 0.0, 255.0));
      }
    }
  }
  return picture;
}

Picture encode(const FloatImage& image, uint32_t samples) {
  Picture picture{image.width / samples, image.height / samples, {}};
  for (uint32_t y = 0; y < picture.height; ++y)
    for (uint32_t x = 0; x < picture.width; ++x)
      for (int channel = 0; channel < 3; ++channel) {
        double sum = 0.0;
        for (uint32_t s = 0; s < samples * samples; ++s)
          sum += double{image.pixel(samples * x + s % samples, samples * y + s / samples)[channel]};
        const double mean = std::clamp(sum / (samples * samples), 0.0, 1.0);
        picture.rgb.push_back(static_cast<uint8_t>(std::floor(255.0 * f64::srgbEncode(mean) + 0.5)));
      }
  return picture;
}

}  // namespace welkin::render
