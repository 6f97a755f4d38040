// SPDX-License-Identifier: Apache-2.0
// Points of a random level, and their light beside that of the double reference.
#pragma once

#include <vector>

#include "tests/runtime/random_level.h"

namespace welkin::tests {

struct Point {
  float position[3], normal[3];
};

/// Points in and about the level, with any normal.
std::vector<Point> somePoints(std::size_t count);

/// Largest difference between the runtime and the reference at many points, relative to the largest irradiance.
/// Demands that both have light at the same points.
double differenceOf(const RandomLevel& baked, OpenedLevel& opened, double time_h);

}  // namespace welkin::tests
