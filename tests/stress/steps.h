// SPDX-License-Identifier: Apache-2.0
// The search for steps of a sky in time and in direction, with bounds for a sky without steps.
#pragma once

#include "tests/sky/always.h"

namespace welkin::stress {

struct Searched {
  tests::Fault fault;     ///< a step, or a curve that is too steep
  bool measured = false;  ///< false where the sky is so steep that a step would not be visible
};

/// Searches from one time to another, h, in two fixed directions and `direction`.
Searched searchTime(const model::Sky& model, const welkin::Sky& baked, double from_h, double to_h,
                    const det::Number3& direction);

/// Searches an arc over the upper hemisphere at one time, from an elevation at an azimuth through the zenith.
Searched searchArc(const model::Sky& model, const welkin::Sky& baked, double time_h, double azimuth_rad,
                   double from_rad);

}  // namespace welkin::stress
