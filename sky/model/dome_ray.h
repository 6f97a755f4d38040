// SPDX-License-Identifier: Apache-2.0
// A direction of the dome with everything that depends on nothing but the direction: it costs as much as the rest of an
// evaluation, and whoever looks in the same directions at many instants pays for it once.
#pragma once

#include "sky/model/luminance.h"

namespace welkin::model {

using det::Number3;

struct DomeRay {
  DomeRay() = default;
  /// `direction` is a unit vector.
  DomeRay(const LuminanceModel& model, const Number3& direction_)
      : direction(direction_),
        elevation_rad(det::elevationOf(direction_)),
        gradation(det::gradation(model, direction_.y)) {}

  Number3 direction{0.0, 1.0, 0.0};
  double elevation_rad = det::kHalfPi;
  double gradation = 1.0;  ///< of the model
};

}  // namespace welkin::model
