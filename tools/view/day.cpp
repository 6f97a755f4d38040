// SPDX-License-Identifier: Apache-2.0
#include "view/day.h"

#include <algorithm>
#include <cmath>

#include "render/tone.h"
#include "shared.h"

namespace welkin::view {
namespace {

double elevationAt(const Sky& sky, double time_h) {
  WelkinSkySample s{};
  sky.sample(time_h, s);
  return std::asin(std::clamp(double{s.sun.direction[1]}, -1.0, 1.0)) / f64::kDegree;
}

/// The time between two at which the elevation changes its sign, to a second.
double crossing(const Sky& sky, double from_h, double to_h) {
  const bool up = elevationAt(sky, from_h) > 0.0;
  while (to_h - from_h > 1.0 / 3600.0) {
    const double middle_h = 0.5 * (from_h + to_h);
    ((elevationAt(sky, middle_h) > 0.0) == up ? from_h : to_h) = middle_h;
  }
  return 0.5 * (from_h + to_h);
}

}  // namespace

Day dayOf(const Sky& sky) {
  Day day;
  for (std::uint32_t i = 0; i < sky.info().key_count; ++i) {
    double time_h = 0.0;
    welkin_sky_key_time(sky.get(), i, &time_h);
    day.key_h.push_back(static_cast<float>(time_h));
  }
  for (std::size_t i = 0; i < kDaySamples; ++i) {
    const double time_h = 24.0 * static_cast<double>(i) / (kDaySamples - 1);
    WelkinSkySample s{};
    sky.sample(time_h, s);
    day.intensity[i] = s.intensity;
    const float* tint = s.polarising_tint;
    day.tint[i] = static_cast<float>(f64::luminanceOf({double{tint[0]}, double{tint[1]}, double{tint[2]}}));
    day.saturation[i] = s.ambient_saturation;
    day.elevation_deg[i] = static_cast<float>(elevationAt(sky, time_h));
    day.irradiance[i] = static_cast<float>(render::openGround(s));
    if (i == 0 || (day.elevation_deg[i] > 0.0F) == (day.elevation_deg[i - 1] > 0.0F)) continue;
    const double at_h = crossing(sky, 24.0 * static_cast<double>(i - 1) / (kDaySamples - 1), time_h);
    (day.elevation_deg[i] > 0.0F ? day.sunrise_h : day.sunset_h).push_back(at_h);
  }
  return day;
}

}  // namespace welkin::view
