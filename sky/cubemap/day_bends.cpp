// SPDX-License-Identifier: Apache-2.0
#include "sky/cubemap/day_bends.h"

#include <algorithm>
#include <cmath>

namespace welkin::cubemap {

using det::Number3;
namespace {

constexpr int kMostColumns = 288;  // more are closer than five minutes: the instants between cubemaps meet them
constexpr double kBend = 0.002;    // of a texel that is worth an instant, of the brightest component, which is about 1

/// Columns at which a gradient's change over the day bends.
std::vector<int> bentColumns(const model::Gradient& gradient) {
  std::vector<int> list;
  const int n = gradient.width;
  for (int i = 0; i < n; ++i) {
    double most = 0.0;
    for (int j = 0; j < gradient.height; ++j) {
      const Number3 bend =
          gradient.texel((i + n - 1) % n, j) - gradient.texel(i, j) * 2.0 + gradient.texel((i + 1) % n, j);
      most = std::max({most, std::abs(bend.x), std::abs(bend.y), std::abs(bend.z)});
    }
    if (most > kBend) list.push_back(i);
  }
  return list;
}

}  // namespace

void tidyHours(std::vector<double>& time_h) {
  for (double& t : time_h) t = format::wrapTime(t);
  std::sort(time_h.begin(), time_h.end());
  time_h.erase(std::unique(time_h.begin(), time_h.end()), time_h.end());
}

std::vector<double> bendsOf(const model::Sky& sky) {
  std::vector<double> time_h;
  const auto height = [&](double t) { return sky.sun.path.directionAt(t).y; };
  constexpr int kSteps = 288;
  for (int i = 0; i < kSteps; ++i) {
    double low = 24.0 * i / kSteps;
    double high = 24.0 * (i + 1) / kSteps;
    const bool up = height(low) > 0.0;
    if (up == (height(high) > 0.0)) continue;
    while (high - low > 1e-6) {
      const double middle = 0.5 * (low + high);
      ((height(middle) > 0.0) == up ? low : high) = middle;
    }
    for (const double apart_h : {-0.12, -0.04, 0.0, 0.04, 0.12}) time_h.push_back(low + apart_h);
  }
  for (const model::Gradient* gradient : {&sky.gradient_sun, &sky.gradient_anti})
    if (gradient->width <= kMostColumns)
      for (const int i : bentColumns(*gradient)) time_h.push_back(24.0 * (i + 0.5) / gradient->width);
  for (const auto* keys : {&sky.intensity.time_h, &sky.polarising_tint.time_h, &sky.sun.path.key_time_h})
    time_h.insert(time_h.end(), keys->begin(), keys->end());
  tidyHours(time_h);
  return time_h;
}

}  // namespace welkin::cubemap
