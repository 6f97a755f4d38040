// SPDX-License-Identifier: Apache-2.0
#include "calibrate/patches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "sh/deterministic.h"

namespace welkin::calibrate {
namespace {

constexpr int kMostSamples = 64;  ///< along a side of the middle of a patch
constexpr int kLeastSamples = 4;  ///< some pixels then serve twice
constexpr double kMiddle = 0.25;  ///< the margin that is left out at each side of a patch

/// The mean of the values from the first to the third quartile.
double middleMean(std::span<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t skip = values.size() / 4;
  double sum = 0.0;
  for (std::size_t i = skip; i < values.size() - skip; ++i) sum += values[i];
  return sum / static_cast<double>(values.size() - 2 * skip);
}

/// Samples of one patch, channel by channel and quarter by quarter.
struct Samples {
  std::array<std::array<std::vector<double>, 4>, 3> value;
  std::size_t clipped = 0, count = 0;
};

Samples samplesOf(const image::Image& image, const ChartPlace& place, std::size_t patch, double full) {
  const double pixels = (1.0 - 2.0 * kMiddle) * place.shortestSide();
  const int n = std::clamp(2 * static_cast<int>(std::ceil(0.5 * pixels)), kLeastSamples, kMostSamples);
  Samples samples;
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column) {
      const auto along = [n](int i) { return kMiddle + (1.0 - 2.0 * kMiddle) * (i + 0.5) / n; };
      const Point at = place.pixelOf(patch, along(column), along(row));
      const auto x = static_cast<std::size_t>(std::clamp(static_cast<int>(at.x()), 0, image.width - 1));
      const auto y = static_cast<std::size_t>(std::clamp(static_cast<int>(at.y()), 0, image.height - 1));
      const float* texel = image.rgb.data() + 3 * (y * static_cast<std::size_t>(image.width) + x);
      const std::size_t quarter = (2 * row >= n ? 2U : 0U) + (2 * column >= n ? 1U : 0U);
      for (std::size_t c = 0; c < 3; ++c) samples.value[c][quarter].push_back(double{texel[c]});
      const bool clips = std::any_of(texel, texel + 3, [full](float v) { return double{v} >= full; });
      samples.clipped += clips ? 1 : 0;
      ++samples.count;
    }
  return samples;
}

Patch patchOf(Samples samples) {
  Patch patch;
  patch.clipped = static_cast<double>(samples.clipped) / static_cast<double>(samples.count);
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<double> all;
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (std::vector<double>& quarter : samples.value[c]) {
      all.insert(all.end(), quarter.begin(), quarter.end());
      const double encoded = det::srgbEncode(std::clamp(middleMean(quarter), 0.0, 1.0));
      least = std::min(least, encoded);
      most = std::max(most, encoded);
    }
    patch.uneven = std::max(patch.uneven, most - least);
    const auto channel = static_cast<int>(c);
    patch.mean[channel] = middleMean(all);
    constexpr double kQuartilesOfNormal = 1.349;
    patch.spread[channel] = (all[all.size() - 1 - all.size() / 4] - all[all.size() / 4]) / kQuartilesOfNormal;
  }
  return patch;
}

}  // namespace

Patches measurePatches(const image::Image& image, const ChartPlace& place, double full) {
  Patches patches;
  for (std::size_t i = 0; i < kPatches; ++i) patches[i] = patchOf(samplesOf(image, place, i, full));
  return patches;
}

double clippingLevel(const image::Image& image, bool linear_codes) {
  // Full codes of ProPhoto RGB are 2.03 in Rec. 709, and no usual profile goes further. More is light, not codes.
  constexpr float kPastCodes = 2.1F;
  const bool is_light = std::any_of(image.rgb.begin(), image.rgb.end(), [](float v) { return v > kPastCodes; });
  if (is_light) return std::numeric_limits<double>::infinity();
  constexpr double kNearlyFull = 253.5 / 255.0;
  return linear_codes ? kNearlyFull : det::srgbDecode(kNearlyFull);
}

}  // namespace welkin::calibrate
