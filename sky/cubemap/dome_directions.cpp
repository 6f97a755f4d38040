// SPDX-License-Identifier: Apache-2.0
#include "sky/cubemap/dome_directions.h"

#include <algorithm>
#include <cmath>

#include "sh/spiral.h"

namespace welkin::cubemap {
namespace {

constexpr double kNearest = 5e-4;   // chord; a quarter of the finest texel, 2 / 1024
constexpr double kFarthest = 0.75;  // chord, 44 degrees
constexpr double kLowest = 1e-3;    // height; half the finest texel
constexpr double kHighest = 0.25;

}  // namespace

DomeDirections::DomeDirections(const DirectionCounts& counts) {
  for (int i = 0; i < counts.even; ++i) staying_.push_back(sh::onSpiral((i + 0.5) / counts.even, i));
  const double heights = det::log(kHighest / kLowest);
  for (int i = 0; i < counts.low; ++i)
    staying_.push_back(sh::onSpiral(kLowest * det::exp(heights * (i + 0.5) / counts.low), i));
  const double chords = det::log(kFarthest / kNearest);
  for (int i = 0; i < counts.about_sun; ++i)
    about_sun_.push_back({kNearest * det::exp(chords * (i + 0.5) / counts.about_sun), det::cos(sh::kGoldenTurn * i),
                          det::sin(sh::kGoldenTurn * i)});
  even_density_ = counts.even / det::kTwoPi;
  sun_density_ = counts.about_sun / (det::kTwoPi * chords);  // a ring of chord r has the solid angle 2 pi r dr
  low_density_ = counts.low / (det::kTwoPi * heights);
}

std::vector<WeightedDirection> DomeDirections::around(const Number3& sun) const {
  std::vector<WeightedDirection> list;
  list.reserve(staying_.size() + about_sun_.size());
  const auto add = [&](const Number3& direction, double chord2) {
    double density = even_density_;
    // Closer than the nearest of the crowd an even one would stand for a whole cell, and the cusp for all of it.
    if (chord2 <= kFarthest * kFarthest) density += sun_density_ / std::max(chord2, kNearest * kNearest);
    if (direction.y >= kLowest && direction.y <= kHighest) density += low_density_ / direction.y;
    list.push_back({direction, 1.0 / density});
  };
  for (const Number3& direction : staying_) {
    const Number3 difference = direction - sun;
    add(direction, dot(difference, difference));
  }
  const Number3 beside = std::abs(sun.y) < 0.7 ? Number3(0.0, 1.0, 0.0) : Number3(1.0, 0.0, 0.0);
  Number3 u = beside - sun * dot(beside, sun);
  u = u * (1.0 / std::sqrt(dot(u, u)));
  const Number3 v(sun.y * u.z - sun.z * u.y, sun.z * u.x - sun.x * u.z, sun.x * u.y - sun.y * u.x);
  for (const Offset& at : about_sun_) {
    const double along = 1.0 - 0.5 * at.chord * at.chord;
    const double across = at.chord * std::sqrt(1.0 - 0.25 * at.chord * at.chord);
    const Number3 direction = sun * along + u * (across * at.cosine) + v * (across * at.sine);
    if (direction.y > 0.0) add(direction, at.chord * at.chord);
  }
  return list;
}

}  // namespace welkin::cubemap
