// SPDX-License-Identifier: Apache-2.0
// How steep a sky is: the change of its dome when the sun or the direction moves a little.
#pragma once

#include "sky/model/sky.h"

namespace welkin::stress {

/// Error of a direction in floats, radians.
inline constexpr double kFloatDirection = 2e-7;

/// Bound of the relative change of the dome's radiance in unit `direction`, y >= 0, for each radian that the sun or the
/// direction moves. Valid for moves that are small beside the lobe's width and the layer's height.
double sensitivityAt(const model::SkyInstant& instant, const det::Number3& direction);

}  // namespace welkin::stress
