// SPDX-License-Identifier: Apache-2.0
#include "command/paint.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "shared.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/image/image.h"

namespace welkin::command {
namespace {

using Colour = f64::Number3;  // sRGB-encoded, as a painter picks it

/// Colours at four elevations: horizon, low sky, mid sky, zenith.
struct Key {
  double time_h;
  std::array<Colour, 4> colour;
};
constexpr std::array<double, 4> kElevation = {0.0, 0.14, 0.42, 1.0};  // of a quarter turn

const std::array<Colour, 4> kNight = {Colour(.30, .38, .52), {.24, .32, .50}, {.18, .26, .46}, {.14, .21, .42}};
const std::array<Colour, 4> kNoon = {Colour(.78, .88, .94), {.58, .78, .95}, {.30, .56, .90}, {.14, .36, .80}};

const std::vector<Key> kSunSide = {
    {0.0, kNight},
    {4.3, kNight},
    {4.9, {Colour(.88, .42, .30), {.62, .40, .52}, {.32, .34, .60}, {.19, .25, .54}}},
    {5.4, {Colour(1.0, .54, .22), {1.0, .58, .42}, {.66, .52, .66}, {.30, .36, .68}}},
    {6.1, {Colour(1.0, .72, .36), {1.0, .76, .52}, {.64, .66, .78}, {.30, .44, .78}}},
    {7.2, {Colour(.98, .89, .71), {.82, .85, .88}, {.45, .65, .90}, {.20, .43, .84}}},
    {9.0, kNoon},
    {15.0, kNoon},
    {17.0, {Colour(1.0, .86, .60), {.88, .84, .78}, {.48, .66, .88}, {.20, .42, .82}}},
    {18.1, {Colour(1.0, .60, .22), {1.0, .66, .38}, {.72, .60, .68}, {.32, .40, .74}}},
    {18.7, {Colour(1.0, .40, .15), {1.0, .44, .29}, {.68, .41, .58}, {.30, .31, .64}}},
    {19.3, {Colour(.86, .29, .25), {.62, .31, .47}, {.36, .29, .57}, {.21, .24, .53}}},
    {20.1, kNight},
};

const std::vector<Key> kAntiSide = {
    {0.0, kNight},
    {4.3, kNight},
    {4.9, {Colour(.28, .32, .54), {.36, .36, .60}, {.28, .33, .60}, {.19, .25, .54}}},
    {5.4, {Colour(.40, .42, .64), {.78, .52, .64}, {.54, .48, .70}, {.30, .36, .68}}},
    {6.1, {Colour(.66, .60, .72), {.88, .69, .72}, {.54, .60, .80}, {.30, .44, .78}}},
    {7.2, {Colour(.78, .83, .88), {.64, .78, .92}, {.37, .60, .90}, {.20, .43, .84}}},
    {9.0, kNoon},
    {15.0, kNoon},
    {17.0, {Colour(.80, .81, .87), {.67, .76, .90}, {.38, .58, .88}, {.20, .42, .82}}},
    {18.1, {Colour(.62, .54, .72), {.90, .62, .72}, {.60, .54, .76}, {.32, .40, .74}}},
    {18.7, {Colour(.38, .38, .64), {.76, .45, .64}, {.52, .41, .68}, {.30, .31, .64}}},
    {19.3, {Colour(.26, .30, .56), {.34, .31, .58}, {.29, .28, .57}, {.21, .24, .53}}},
    {20.1, kNight},
};

double ease(double t) {
  return t * t * (3.0 - 2.0 * t);
}

Colour overElevation(const std::array<Colour, 4>& colour, double elevation) {
  std::size_t i = 0;
  while (i < 2 && elevation > kElevation[i + 1]) ++i;
  return mix(colour[i], colour[i + 1], ease((elevation - kElevation[i]) / (kElevation[i + 1] - kElevation[i])));
}

Colour paint(const std::vector<Key>& keys, double time_h, double elevation) {
  std::size_t second = 0;
  while (second < keys.size() && keys[second].time_h <= time_h) ++second;
  const Key& a = keys[second - 1];  // the first key is at 0 h
  const Key& b = keys[second % keys.size()];
  const double end = second == keys.size() ? 24.0 : b.time_h;
  return mix(overElevation(a.colour, elevation), overElevation(b.colour, elevation),
             ease((time_h - a.time_h) / (end - a.time_h)));
}

}  // namespace

void writeStartingGradient(GradientSide side, const std::filesystem::path& path) {
  constexpr int kWidth = 96;
  constexpr int kHeight = 32;
  std::vector<std::uint16_t> texels;
  for (int row = 0; row < kHeight; ++row)
    for (int column = 0; column < kWidth; ++column) {
      const double elevation = (kHeight - row - 0.5) / kHeight;  // the first row is nearest the zenith
      const Colour c =
          paint(side == GradientSide::sun ? kSunSide : kAntiSide, 24.0 * (column + 0.5) / kWidth, elevation);
      for (int i = 0; i < 3; ++i) texels.push_back(static_cast<std::uint16_t>(std::floor(c[i] * 65535.0 + 0.5)));
    }
  writePaintedPng(path, kWidth, kHeight, 16, texels);
}

void writePaintedPng(const std::filesystem::path& path, int width, int height, int bits,
                     const std::vector<std::uint16_t>& rgb) {
  if (bits == 16) return base::writeFile(path, image::encodePng(width, height, rgb));
  std::vector<std::uint8_t> bytes(rgb.size());
  std::transform(rgb.begin(), rgb.end(), bytes.begin(),
                 [](std::uint16_t v) { return static_cast<std::uint8_t>((v + 128) / 257); });
  base::writeFile(path, image::encodePng(width, height, bytes));
}

}  // namespace welkin::command
