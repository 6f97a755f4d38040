// SPDX-License-Identifier: Apache-2.0
#include "probes/transfer/light_track.h"

#include <algorithm>
#include <cmath>

namespace welkin::transfer {
namespace {

constexpr double kDay_h = 24.0;

/// The last time on the upper side of the horizon, between a time when the light is up and one when it is not.
double crossingBetween(const std::function<Number3(double)>& direction_at, double up, double down) {
  constexpr int kHalvings = 40;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (up + down);
    (direction_at(middle).y > 0.0 ? up : down) = middle;
  }
  return up;
}

}  // namespace

LightTrack trackOf(const std::function<Number3(double)>& direction_at, int knots_a_day) {
  std::vector<double> times;
  const double step = kDay_h / knots_a_day;
  for (int i = 0; i < knots_a_day; ++i) {
    const double before = step * i;
    const double after = step * (i + 1);
    const bool up = direction_at(before).y > 0.0;
    if (up) times.push_back(before);
    if (up == (direction_at(after).y > 0.0)) continue;
    const double crossing =
        up ? crossingBetween(direction_at, before, after) : crossingBetween(direction_at, after, before);
    if (crossing > before && crossing < after) times.push_back(crossing);
  }
  LightTrack track;
  track.time_h = std::move(times);
  for (const double time : track.time_h) track.direction.push_back(direction_at(time));
  return track;
}

TrackPlace placeOnTrack(const std::vector<double>& knot_time_h, double time_h) {
  double time = time_h - kDay_h * std::floor(time_h / kDay_h);
  if (time >= kDay_h) time = 0.0;  // -1e-300, for one, rounds to a full day
  const auto next = std::upper_bound(knot_time_h.begin(), knot_time_h.end(), time);
  const auto count = knot_time_h.size();
  const auto after = static_cast<std::size_t>(next - knot_time_h.begin());
  TrackPlace place;
  place.before = after == 0 ? count - 1 : after - 1;
  place.after = after == count ? 0 : after;
  const double start = knot_time_h[place.before] - (after == 0 ? kDay_h : 0.0);
  const double end = knot_time_h[place.after] + (after == count ? kDay_h : 0.0);
  place.share = end > start ? (time - start) / (end - start) : 0.0;
  return place;
}

}  // namespace welkin::transfer
