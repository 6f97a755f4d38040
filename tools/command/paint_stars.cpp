// SPDX-License-Identifier: Apache-2.0
// The starting star map: a few thousand stars and a band of faint light, from integer hashes.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "command/paint.h"
#include "sh/deterministic.h"

namespace welkin::command {
namespace {

constexpr int kWidth = 1024;
constexpr int kHeight = 512;
constexpr int kStars = 2600;

/// A well mixed 32-bit hash (Wellons, "Prospecting for Hash Functions", 2018: lowbias32), as a number in [0, 1).
double hashed(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x7feb352dU;
  x ^= x >> 15;
  x *= 0x846ca68bU;
  x ^= x >> 16;
  return x / 4294967296.0;
}

/// Linear light, row-major RGB.
struct Map {
  std::vector<double> rgb = std::vector<double>(static_cast<std::size_t>(kWidth) * kHeight * 3);
  void add(int column, int row, const std::array<double, 3>& light) {
    if (row < 0 || row >= kHeight) return;
    const auto at = static_cast<std::size_t>(row * kWidth + (column % kWidth + kWidth) % kWidth) * 3;
    for (std::size_t c = 0; c < 3; ++c) rgb[at + c] += light[c];
  }
};

/// A faint band along a great circle, broken up by the hash of coarse cells.
void paintBand(Map& map) {
  const det::Number3 pole(0.35, 0.5, 0.7921);
  for (int row = 0; row < kHeight; ++row)
    for (int column = 0; column < kWidth; ++column) {
      const double declination = det::kPi * (0.5 - (row + 0.5) / kHeight);
      const double angle = det::kTwoPi * (column + 0.5) / kWidth;
      const det::Number3 d(det::cos(declination) * det::cos(angle), det::sin(declination),
                           det::cos(declination) * det::sin(angle));
      const double away = dot(d, pole);
      double cloud = 0.0;
      for (int octave = 0; octave < 4; ++octave) {
        const double s = 3.0 * (1 << octave);
        const double wave =
            det::sin(s * d.x + 1.7 * octave) * det::sin(s * d.y + 2.9) * det::sin(s * d.z + 0.6 * octave);
        cloud += wave / (1 << octave);
      }
      const double band = det::exp(-away * away * 28.0) * std::max(0.0, 0.5 + 0.8 * cloud);
      map.add(column, row, {0.010 * band, 0.011 * band, 0.014 * band});
    }
}

void paintStars(Map& map) {
  for (std::uint32_t i = 0; i < kStars; ++i) {
    const double height = 2.0 * hashed(4 * i) - 1.0;  // uniform over the sphere
    const double declination = det::atan(height, std::sqrt(1.0 - height * height));
    const double column = hashed(4 * i + 1) * kWidth;
    const double row = (0.5 - declination / det::kPi) * kHeight - 0.5;
    const double rank = hashed(4 * i + 2);
    const double brightness = std::min(1.0, 0.007 / (rank + 0.006));  // few bright stars, many faint ones
    const double warm = hashed(4 * i + 3) - 0.5;
    const std::array<double, 3> light = {brightness * (1.0 + 0.5 * warm), brightness, brightness * (1.0 - 0.6 * warm)};
    const double left = std::floor(column);
    const double low = std::floor(row);
    for (int dy = 0; dy < 2; ++dy)  // spread over the four nearest texels
      for (int dx = 0; dx < 2; ++dx) {
        const double share = std::abs(1 - dx - (column - left)) * std::abs(1 - dy - (row - low));
        map.add(static_cast<int>(left) + dx, static_cast<int>(low) + dy,
                {light[0] * share, light[1] * share, light[2] * share});
      }
  }
}

}  // namespace

void writeStartingStars(const std::filesystem::path& path) {
  Map map;
  paintBand(map);
  paintStars(map);
  std::vector<std::uint16_t> texels;
  texels.reserve(map.rgb.size());
  for (const double v : map.rgb)
    texels.push_back(static_cast<std::uint16_t>(257 * std::floor(det::srgbEncode(std::min(v, 1.0)) * 255.0 + 0.5)));
  writePaintedPng(path, kWidth, kHeight, 8, texels);
}

}  // namespace welkin::command
