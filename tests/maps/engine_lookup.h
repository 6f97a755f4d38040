// SPDX-License-Identifier: Apache-2.0
// How each engine looks up a direction in a cube and in a latlong, from the engines' own sources, one formula each.
#pragma once

#include <cmath>
#include <vector>

#include "sh/deterministic.h"

namespace welkin::tests {

/// A place in a cube: (s, t) from the upper left corner of a face, in [0, 1].
struct CubePlace {
  int face;
  double s, t;
};

/// A place in a latlong, from its upper left corner, in [0, 1].
struct LatlongPlace {
  double u, v;
};

struct EngineLookup {
  const char* engine;
  CubePlace (*cube)(const det::Number3& welkin_direction);
  LatlongPlace (*latlong)(const det::Number3& welkin_direction);
};

/// All engines, and Welkin itself as "welkin".
const std::vector<EngineLookup>& engineLookups();

/// A random unit direction.
template <typename Random>
det::Number3 randomDirection(Random& random) {
  for (;;) {
    const auto number = [&] {
      return 2.0 * static_cast<double>(random() - Random::min()) / static_cast<double>(Random::max() - Random::min()) -
             1.0;
    };
    const double x = number(), y = number(), z = number(), square = x * x + y * y + z * z;
    if (square > 0.01 && square < 1.0) return det::Number3(x, y, z) / std::sqrt(square);
  }
}

}  // namespace welkin::tests
