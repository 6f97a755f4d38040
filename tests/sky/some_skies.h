// SPDX-License-Identifier: Apache-2.0
// Skies for tests that depend on the whole day: a clear day in colours, a cusp that rises and sets, a layer at the
// horizon, an even cover. None is symmetric.
#pragma once

#include <string>
#include <vector>

#include "sky/model/sky.h"

namespace welkin::tests {

struct NamedSky {
  std::string name;
  model::Sky sky;
  std::vector<double> time_h;  ///< of cubemaps that suit it
};

std::vector<NamedSky> someSkies();

/// Hours of a day from midnight.
inline std::vector<double> everyHours(double step_h) {
  std::vector<double> hours;
  for (int i = 0; i * step_h < 24.0; ++i) hours.push_back(i * step_h);
  return hours;
}

}  // namespace welkin::tests
