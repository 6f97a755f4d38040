// SPDX-License-Identifier: Apache-2.0
// The part of a light's daily path above the horizon. Transfer is known at its knots and linear between them.
#pragma once

#include <functional>
#include <vector>

#include "shared.h"

namespace welkin::transfer {

using f64::Number3;

/// Knots in ascending time, in [0, 24). Each stretch above the horizon begins and ends with a knot on the horizon.
struct LightTrack {
  std::vector<double> time_h;
  std::vector<Number3> direction;  ///< unit, y > 0
};

/// Samples a light's direction, which has a period of 24 h. While the light is up there is a knot every day /
/// `knots_a_day`, and one at each crossing between two such times. A light that never rises has no knots. knots_a_day
/// >= 2.
LightTrack trackOf(const std::function<Number3(double time_h)>& direction_at, int knots_a_day);

/// Two neighbouring knots of a track and the position between them.
struct TrackPlace {
  std::size_t before = 0;
  std::size_t after = 0;
  double share = 0.0;  ///< weight of `after`, in [0, 1]
};

/// Finds the knots around a finite time. `knot_time_h` is not empty and ascends in [0, 24). After the last knot comes
/// the first one of the next day. The result does not tell whether the light is up.
TrackPlace placeOnTrack(const std::vector<double>& knot_time_h, double time_h);

}  // namespace welkin::transfer
