// SPDX-License-Identifier: Apache-2.0
#include "calibrate/find_charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sh/deterministic.h"
#include "sky/base/error.h"
#include "sky/base/module.h"

namespace welkin::calibrate {

const ChartModule& chartModule() {
  static const ChartModule* const kModule = [] {
    void* entry = base::loadModule(WELKIN_CHART_MODULE, kChartModuleEntry, "the detector of charts");
    return reinterpret_cast<const ChartModule* (*)()>(entry)();
  }();
  return *kModule;
}

namespace {

/// The value that all but one texel in a hundred do not exceed.
float brightOf(const image::Image& image) {
  std::vector<float> value;
  constexpr std::size_t kMost = std::size_t{1} << 20;
  const std::size_t texels = image.rgb.size() / 3;
  const std::size_t step = std::max<std::size_t>(1, texels / kMost);
  for (std::size_t i = 0; i < texels; i += step)
    value.push_back(std::max({image.rgb[3 * i], image.rgb[3 * i + 1], image.rgb[3 * i + 2]}));
  const auto at = value.begin() + static_cast<std::ptrdiff_t>(value.size() * 99 / 100);
  std::nth_element(value.begin(), at, value.end());
  return *at;
}

/// The picture reduced by whole numbers of pixels, by the mean of linear light, times `gain`, encoded to 8 bits.
struct Reduced {
  int width, height;
  std::vector<std::uint8_t> bgr;
};

Reduced reduced(const image::Image& image, int factor, double gain) {
  Reduced result{image.width / factor, image.height / factor, {}};
  result.bgr.reserve(3 * static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height));
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x)
      for (int c = 2; c >= 0; --c) {
        double sum = 0.0;
        for (int row = 0; row < factor; ++row)
          for (int column = 0; column < factor; ++column) {
            const auto i = static_cast<std::size_t>(y * factor + row) * static_cast<std::size_t>(image.width) +
                           static_cast<std::size_t>(x * factor + column);
            sum += double{image.rgb[3 * i + static_cast<std::size_t>(c)]};
          }
        const double light = std::clamp(gain * sum / (factor * factor), 0.0, 1.0);
        result.bgr.push_back(static_cast<std::uint8_t>(std::lround(255.0 * det::srgbEncode(light))));
      }
  return result;
}

}  // namespace

std::vector<Candidate> findCandidates(const image::Image& image,
                                      const std::function<bool(const std::vector<Candidate>&)>& enough) {
  constexpr int kUsualSide = 2048;  // a chart of a tenth of the picture still has patches of 30 pixels
  constexpr int kLeastSide = 64;    // the detector's patterns need some pixels a patch
  const double bright = double{brightOf(image)};
  if (!(bright > 0.0) || std::min(image.width, image.height) < kLeastSide) return {};
  const int usual = (std::max(image.width, image.height) + kUsualSide - 1) / kUsualSide;
  const double stretch = 0.9 / bright;
  std::vector<int> factors = {usual, 2 * usual};
  if (usual > 1) factors.push_back(usual / 2);
  std::vector<Candidate> first;
  for (const int factor : factors)
    for (const double gain : {1.0, stretch}) {
      const Reduced small = reduced(image, factor, gain);
      if (std::min(small.width, small.height) < kLeastSide) continue;
      std::vector<Candidate> found = chartModule().detect(small.width, small.height, small.bgr.data());
      for (Candidate& candidate : found)
        for (Point& p : candidate.corners) p *= double{static_cast<double>(factor)};
      if (!found.empty() && (!enough || enough(found))) return found;
      if (first.empty()) first = std::move(found);
    }
  return first;
}

}  // namespace welkin::calibrate
