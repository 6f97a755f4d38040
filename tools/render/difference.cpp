// SPDX-License-Identifier: Apache-2.0
#include "render/difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "render/picture.h"
#include "shared.h"

namespace welkin::render {
namespace {

constexpr uint8_t kNothing = 40;  // grey of pixels that were not traced
constexpr uint32_t kLine = 22;    // height of a line of words below the picture

struct PixelError {
  double difference, traced, noise;
};

double luminanceAt(const float* rgb) {
  return f64::luminanceOf({double{rgb[0]}, double{rgb[1]}, double{rgb[2]}});
}

/// A value for each pixel of the picture, row by row.
std::vector<std::optional<PixelError>> pixelsOf(const FloatImage& drawn, const TracedImage& traced, uint32_t samples) {
  std::vector<std::optional<PixelError>> pixels;
  for (uint32_t y = 0; y < drawn.height / samples; ++y)
    for (uint32_t x = 0; x < drawn.width / samples; ++x) {
      PixelError sum{};
      double count = 0.0;
      for (uint32_t s = 0; s < samples * samples; ++s) {
        const uint32_t at_x = samples * x + s % samples;
        const uint32_t at_y = samples * y + s / samples;
        const float* got = drawn.pixel(at_x, at_y);
        const float* want = traced.irradiance.pixel(at_x, at_y);
        if (!(got[3] > 0.0F && want[3] > 0.0F)) continue;
        const double off = double{traced.error[std::size_t{at_y} * drawn.width + at_x]};
        sum.difference += luminanceAt(got) - luminanceAt(want);
        sum.traced += luminanceAt(want);
        sum.noise += off * off;
        count += 1.0;
      }
      if (count == 0.0)
        pixels.emplace_back();
      else
        pixels.push_back(PixelError{sum.difference / count, sum.traced / count, std::sqrt(sum.noise) / count});
    }
  return pixels;
}

/// The least of 1, 2, 5 times a power of ten that is not below x > 0.
double roundedUp(double x) {
  const double power = std::pow(10.0, std::floor(std::log10(x)));
  for (const double step : {1.0, 2.0, 5.0})
    if (x <= step * power * (1.0 + 1e-9)) return step * power;
  return 10.0 * power;
}

/// Blue, white, red for -1, 0, 1 (Moreland, "Diverging Color Maps for Scientific Visualization", 2009: their ends).
void paint(uint8_t* rgb, double value) {
  constexpr std::array<double, 3> kDark = {59, 76, 192};
  constexpr std::array<double, 3> kEqual = {245, 245, 245};
  constexpr std::array<double, 3> kBright = {180, 4, 38};
  const double share = std::min(std::abs(value), 1.0);
  for (std::size_t c = 0; c < 3; ++c) {
    const double end = value < 0.0 ? kDark[c] : kBright[c];
    rgb[c] = static_cast<uint8_t>(std::lround(kEqual[c] + share * (end - kEqual[c])));
  }
}

/// Half of the scale's length, so that 98 % of the pixels are within.
double scaleEnd(const std::vector<std::optional<PixelError>>& pixels) {
  std::vector<double> sizes;
  for (const auto& pixel : pixels)
    if (pixel) sizes.push_back(std::abs(pixel->difference));
  if (sizes.empty()) return 1.0;
  const auto at = sizes.begin() + static_cast<std::ptrdiff_t>(0.98 * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), at, sizes.end());
  return *at;
}

}  // namespace

IrradianceError errorOf(const FloatImage& drawn, const TracedImage& traced, uint32_t samples) {
  IrradianceError error;
  double squares = 0.0;
  double noise = 0.0;
  for (const auto& pixel : pixelsOf(drawn, traced, samples)) {
    if (!pixel) continue;
    ++error.pixels;
    error.unit += pixel->traced;
    error.mean += pixel->difference;
    squares += pixel->difference * pixel->difference;
    noise += pixel->noise * pixel->noise;
    if (std::abs(pixel->difference) > std::abs(error.worst)) error.worst = pixel->difference;
  }
  if (!(error.unit > 0.0)) return {};
  const auto count = static_cast<double>(error.pixels);
  error.unit /= count;
  error.mean /= count * error.unit;
  error.rms = std::sqrt(std::max(squares - noise, 0.0) / count) / error.unit;
  error.noise = std::sqrt(noise / count) / error.unit;
  error.worst /= error.unit;
  return error;
}

std::string errorText(const IrradianceError& error) {
  return fmt::format("rms {:.1f} %, mean {:+.1f} %, worst {:+.0f} %", 100.0 * error.rms, 100.0 * error.mean,
                     100.0 * error.worst);
}

Picture differencePicture(const FloatImage& drawn, const TracedImage& traced, uint32_t samples,
                          const IrradianceError& error) {
  const auto pixels = pixelsOf(drawn, traced, samples);
  const double unit = error.unit > 0.0 ? error.unit : 1.0;
  const double end = roundedUp(std::max(scaleEnd(pixels) / unit, 1e-3));
  Picture picture{drawn.width / samples, drawn.height / samples, {}};
  const uint32_t height = picture.height;
  picture.height += 4 * kLine;
  picture.rgb.assign(std::size_t{3} * picture.width * picture.height, kGround);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    uint8_t* rgb = picture.rgb.data() + 3 * i;
    if (pixels[i])
      paint(rgb, pixels[i]->difference / unit / end);
    else
      std::fill_n(rgb, 3, kNothing);
  }
  const uint32_t left = picture.width / 8;
  const uint32_t width = std::max(picture.width - 2 * left, 1U);
  for (uint32_t y = height + 6; y < height + kLine - 2; ++y)
    for (uint32_t x = 0; x < width; ++x)
      paint(picture.rgb.data() + std::size_t{3} * (std::size_t{y} * picture.width + left + x),
            2.0 * (x + 0.5) / width - 1.0);
  const auto words = [&](uint32_t x, uint32_t line, uint32_t room, const std::string& text) {
    drawWords(picture, x, height + line * kLine + kLine / 2, room, text);
  };
  words(left, 1, width / 3, fmt::format("{:+.4g} %", -100.0 * end));
  words(left + width / 2, 1, width / 3, "equal");
  words(left + width, 1, width / 3, fmt::format("{:+.4g} %", 100.0 * end));
  words(picture.width / 2, 2, picture.width, errorText(error));
  words(picture.width / 2, 3, picture.width,
        fmt::format("of the path tracer's mean irradiance, {:.4g}, without its noise of {:.1f} %", error.unit,
                    100.0 * error.noise));
  return picture;
}

}  // namespace welkin::render
