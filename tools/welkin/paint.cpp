// SPDX-License-Identifier: Apache-2.0
#include "welkin/paint.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "shared.h"
#include "sky/atomic_file.h"
#include "sky/error.h"

namespace welkin::tools {
namespace {

using Colour = f64::Number3;  // sRGB-encoded, as a painter picks it

/// Colours at four elevations: horizon, low sky, mid sky, zenith.
struct Key {
  double time_h;
  std::array<Colour, 4> colour;
};
constexpr std::array<double, 4> kElevation = {0.0, 0.14, 0.42, 1.0};  // of a quarter turn

const std::array<Colour, 4> kNight = {Colour(.30, .38, .52), {.24, .32, .50}, {.18, .26, .46}, {.14, .21, .42}};
const std::array<Colour, 4> kNoon = {Colour(.80, .90, .95), {.64, .82, .96}, {.40, .66, .94}, {.22, .50, .90}};

const std::vector<Key> kSunSide = {
    {0.0, kNight},
    {4.3, kNight},
    {4.9, {Colour(.86, .44, .34), {.62, .42, .52}, {.34, .36, .58}, {.20, .27, .52}}},
    {5.4, {Colour(1.0, .56, .26), {.98, .60, .46}, {.62, .54, .68}, {.34, .42, .68}}},
    {6.1, {Colour(1.0, .72, .36), {1.0, .78, .58}, {.74, .74, .80}, {.42, .56, .80}}},
    {7.2, {Colour(.98, .90, .74), {.86, .88, .88}, {.56, .74, .92}, {.32, .56, .88}}},
    {9.0, kNoon},
    {15.0, kNoon},
    {17.0, {Colour(1.0, .88, .66), {.94, .86, .78}, {.62, .74, .88}, {.34, .56, .86}}},
    {18.1, {Colour(1.0, .62, .26), {1.0, .68, .44}, {.80, .66, .70}, {.42, .50, .76}}},
    {18.7, {Colour(1.0, .42, .18), {.98, .46, .34}, {.68, .44, .60}, {.34, .36, .64}}},
    {19.3, {Colour(.84, .30, .28), {.60, .32, .48}, {.36, .30, .56}, {.22, .25, .52}}},
    {20.1, kNight},
};

const std::vector<Key> kAntiSide = {
    {0.0, kNight},
    {4.3, kNight},
    {4.9, {Colour(.30, .34, .52), {.36, .38, .58}, {.30, .36, .58}, {.20, .27, .52}}},
    {5.4, {Colour(.42, .44, .62), {.74, .54, .64}, {.56, .52, .70}, {.34, .42, .68}}},
    {6.1, {Colour(.66, .60, .70), {.88, .70, .72}, {.62, .68, .82}, {.42, .56, .80}}},
    {7.2, {Colour(.80, .84, .88), {.70, .82, .92}, {.48, .70, .92}, {.32, .56, .88}}},
    {9.0, kNoon},
    {15.0, kNoon},
    {17.0, {Colour(.84, .84, .88), {.74, .80, .90}, {.50, .68, .90}, {.34, .56, .86}}},
    {18.1, {Colour(.64, .56, .70), {.88, .64, .72}, {.66, .62, .78}, {.42, .50, .76}}},
    {18.7, {Colour(.40, .40, .62), {.72, .46, .64}, {.54, .44, .68}, {.34, .36, .64}}},
    {19.3, {Colour(.28, .32, .54), {.34, .32, .56}, {.30, .30, .56}, {.22, .25, .52}}},
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
  OIIO::Filesystem::IOVecOutput memory;
  auto output = OIIO::ImageOutput::create("png");
  OIIO::ImageSpec spec(kWidth, kHeight, 3, OIIO::TypeDesc::UINT16);
  spec.attribute("oiio:ColorSpace", "sRGB");
  if (!output || !output->set_ioproxy(&memory) || !output->open("gradient.png", spec) ||
      !output->write_image(OIIO::TypeDesc::UINT16, texels.data()) || !output->close())
    throw Error(ExitStatus::internal, fmt::format("{}: PNG encoding failed: {}", path.string(), OIIO::geterror()));
  writeFile(path, std::as_bytes(std::span(memory.buffer())));
}

}  // namespace welkin::tools
