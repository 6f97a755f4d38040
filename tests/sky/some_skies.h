// SPDX-License-Identifier: Apache-2.0
// Skies that try what depends on the whole day: a clear day in colours, a cusp that rises and sets, a layer at the
// horizon, an even cover; none is symmetric.
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

}  // namespace welkin::tests
