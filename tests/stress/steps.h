// SPDX-License-Identifier: Apache-2.0
// The search for steps of a sky in time and in direction, and what a sky may change by without one.
#pragma once

#include "tests/sky/always.h"

namespace welkin::stress {

struct Searched {
  tests::Fault fault;     ///< of a step, or of a curve that is too steep
  bool measured = false;  ///< false where the sky is so steep that a step could not be told
};

/// From one time to another, h, in two directions and `direction`.
Searched searchTime(const model::Sky& model, const welkin::Sky& baked, double from_h, double to_h,
                    const det::Number3& direction);

/// Over the upper hemisphere at a time, from an elevation at an azimuth through the zenith.
Searched searchArc(const model::Sky& model, const welkin::Sky& baked, double time_h, double azimuth_rad,
                   double from_rad);

}  // namespace welkin::stress
