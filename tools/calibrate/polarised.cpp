// SPDX-License-Identifier: Apache-2.0
#include "calibrate/polarised.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "sky/base/error.h"

namespace welkin::calibrate {

Specular specularOf(const image::Image& crossed, const image::Image& parallel, const std::string& parallel_name,
                    const Model& model) {
  if (crossed.width != parallel.width || crossed.height != parallel.height)
    throw base::Error(
        base::ExitStatus::content,
        fmt::format("{}: {} x {} pixels; the crossed photograph has {} x {}, and both must be of one size",
                    parallel_name, parallel.width, parallel.height, crossed.width, crossed.height));
  Specular result;
  result.image.width = crossed.width;
  result.image.height = crossed.height;
  result.image.rgb.resize(crossed.rgb.size());
  const std::size_t texels = crossed.rgb.size() / 3;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, texels, 4096), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const auto at = [i](const image::Image& image) {
        const float* rgb = image.rgb.data() + 3 * i;
        return Colour(double{rgb[0]}, double{rgb[1]}, double{rgb[2]});
      };
      const Colour x = at(crossed);
      const Colour light = model(0.5 * (x + at(parallel))) - model(x);
      for (std::size_t c = 0; c < 3; ++c)
        result.image.rgb[3 * i + c] = static_cast<float>(std::max(0.0, light[static_cast<int>(c)]));
    }
  });
  std::size_t below = 0;
  for (std::size_t i = 0; i < texels; ++i) below += parallel.rgb[3 * i + 1] < crossed.rgb[3 * i + 1] ? 1 : 0;
  result.below = static_cast<double>(below) / static_cast<double>(std::max<std::size_t>(1, texels));
  return result;
}

}  // namespace welkin::calibrate
