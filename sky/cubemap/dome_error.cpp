// SPDX-License-Identifier: Apache-2.0
#include "sky/cubemap/dome_error.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "sky/cubemap/day_bends.h"
#include "sky/cubemap/dome_scale.h"

namespace welkin::cubemap {

using det::Number3;
namespace {

/// Hours to look at: the bends, the gradients' columns, between which the rounding is blended, and an even day.
std::vector<double> instantsOf(const model::Sky& sky, int even) {
  std::vector<double> time_h = bendsOf(sky);
  for (const model::Gradient* gradient : {&sky.gradient_sun, &sky.gradient_anti})
    for (int i = 0; i < gradient->width; ++i) time_h.push_back(24.0 * (i + 0.5) / gradient->width);
  for (int i = 0; i < even; ++i) time_h.push_back(24.0 * i / even);
  std::sort(time_h.begin(), time_h.end());
  time_h.erase(std::unique(time_h.begin(), time_h.end()), time_h.end());
  return time_h;
}

CubemapError errorAt(const model::Sky& sky, const model::Sky& shown, const DomeScale& scale,
                     const DomeDirections& directions, double time_h) {
  const model::SkyInstant model(sky, time_h);
  const model::SkyInstant file(shown, time_h);
  Number3 mean(0.0);
  Number3 square(0.0);
  double whole = 0.0;
  Number3 largest(0.0);
  Number3 where[3];
  for (const auto& [direction, solid_angle] : directions.around(model.sunDirection())) {
    const Number3 radiance = model.dome(direction, Number3(0.0));
    const Number3 difference = file.dome(direction, Number3(0.0)) - radiance;
    mean += radiance * solid_angle;
    square += difference * difference * solid_angle;
    whole += solid_angle;
    for (int c = 0; c < 3; ++c)
      if (std::abs(difference[c]) > largest[c]) {
        largest[c] = std::abs(difference[c]);
        where[c] = direction;
      }
  }
  CubemapError result;
  result.time_h = time_h;
  for (int c = 0; c < 3; ++c) {
    const double divisor = scale.of(mean * (1.0 / whole), c);
    if (!(divisor > 0.0)) continue;
    const double error = std::sqrt(square[c] / whole) / divisor;
    if (error > result.error) {
      result.error = error;
      result.channel = c;
    }
    if (largest[c] / divisor > result.largest.error) result.largest = {largest[c] / divisor, time_h, where[c], c};
  }
  return result;
}

}  // namespace

CubemapError measureGradients(const model::Sky& sky, model::GradientFormat texel_format, Effort effort) {
  CubemapError result;
  if (texel_format == model::GradientFormat::rgb32f) return result;
  model::Sky shown = sky;
  shown.gradient_sun = model::rounded(sky.gradient_sun, texel_format);
  shown.gradient_anti = model::rounded(sky.gradient_anti, texel_format);
  const DomeScale scale(sky);
  const DomeDirections directions(effort == Effort::full ? DirectionCounts{6144, 1024, 3072}
                                                         : DirectionCounts{768, 128, 384});
  const std::vector<double> time_h = instantsOf(sky, effort == Effort::full ? 288 : 48);
  std::vector<CubemapError> found(time_h.size());
  tbb::parallel_for(std::size_t{0}, time_h.size(),
                    [&](std::size_t i) { found[i] = errorAt(sky, shown, scale, directions, time_h[i]); });
  for (std::size_t i = 0; i < found.size(); ++i) {
    const CubemapError& at = found[i];
    if (at.error > result.error) {
      result.error = at.error;
      result.time_h = at.time_h;
      result.channel = at.channel;
    }
    if (at.largest.error > result.largest.error) result.largest = at.largest;
    result.day.push_back({at.time_h, at.error});
    const double before = i > 0 ? time_h[i - 1] : time_h.back() - format::kDay_h;
    const double after = i + 1 < time_h.size() ? time_h[i + 1] : time_h.front() + format::kDay_h;
    result.mean += at.error * (after - before) / 48.0;  // half of the span between the neighbours
  }
  result.parts.encoding = result.error;
  return result;
}

}  // namespace welkin::cubemap
