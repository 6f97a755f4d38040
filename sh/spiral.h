// SPDX-License-Identifier: Apache-2.0
// Directions along a golden-angle spiral about +y, evenly spread over any range of heights.
#pragma once

#include "sh/deterministic.h"

namespace welkin::sh {

inline const double kGoldenTurn = det::kPi * (3.0 - std::sqrt(5.0));

/// The i-th unit direction, at a height (y) in [-1, 1]. Heights 1 - (2 i + 1) / count spread evenly over the sphere.
inline det::Number3 onSpiral(double height, int i) {
  const double length = std::sqrt(1.0 - height * height);
  return {length * det::cos(kGoldenTurn * i), height, length * det::sin(kGoldenTurn * i)};
}

}  // namespace welkin::sh
