// SPDX-License-Identifier: Apache-2.0
// The part of a light's daily path that is above the horizon, by knots: transfer is known there, and linear between.
#pragma once

#include <functional>
#include <vector>

#include "shared.h"

namespace welkin::transfer {

using f64::Number3;

/// Knots in ascending time, in [0, 24). The first and last of each stretch above the horizon are where it crosses it.
struct LightTrack {
  std::vector<double> time_h;
  std::vector<Number3> direction;  ///< unit, y > 0
};

/// Of a light's direction over the day, period 24 h: a knot every day / `knots_a_day` while it is up, and one at each
/// crossing that two such times enclose. A light that never rises has none. knots_a_day >= 2.
LightTrack trackOf(const std::function<Number3(double time_h)>& direction_at, int knots_a_day);

/// Two neighbours of a track and how far between them.
struct TrackPlace {
  std::size_t before = 0;
  std::size_t after = 0;
  double share = 0.0;  ///< of `after`, in [0, 1]
};

/// Of knots' times, not empty, ascending in [0, 24): where a finite time is among them; past the last one comes the
/// first of the next day. It says nothing of whether the light is up.
TrackPlace placeOnTrack(const std::vector<double>& knot_time_h, double time_h);

}  // namespace welkin::transfer
