// SPDX-License-Identifier: Apache-2.0
#include "sky/cubemap/dome_scale.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "sky/cubemap/day_bends.h"
#include "sky/cubemap/dome_directions.h"

namespace welkin::cubemap {
namespace {

constexpr double kDarkest = 1e-4;  // as a share of the day's brightest instant
constexpr int kScaleDirections = 192;

}  // namespace

DomeScale::DomeScale(const model::Sky& sky) : floor_(0.0) {
  const DomeDirections even({kScaleDirections, 0, 0});
  std::vector<model::DomeRay> rays;
  for (const Number3& d : even.staying()) rays.emplace_back(sky.luminance, d);
  std::vector<double> time_h = bendsOf(sky);
  for (int i = 0; i < 96; ++i) time_h.push_back(0.25 * i);
  tidyHours(time_h);
  std::vector<double> mean(time_h.size());
  tbb::parallel_for(std::size_t{0}, time_h.size(), [&](std::size_t i) {
    const model::SkyInstant instant(sky, time_h[i]);
    for (const model::DomeRay& ray : rays) mean[i] += det::luminanceOf(instant.dome(ray, nullptr)) / kScaleDirections;
  });
  floor_ = kDarkest * *std::max_element(mean.begin(), mean.end());
}

double DomeScale::of(const Number3& mean, int channel) const {
  return std::max({mean[channel], det::luminanceOf(mean), floor_});
}

}  // namespace welkin::cubemap
