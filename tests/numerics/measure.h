// SPDX-License-Identifier: Apache-2.0
// The largest error of every shared formula in units of the last place, and the arguments that give it.
#pragma once

#include <string>
#include <vector>

namespace welkin::numerics {

struct Worst {
  double ulp = 0.0;
  std::string where;
};

struct Measured {
  std::string formula;
  Worst floats;        ///< the CPU's floats against double
  Worst gpu;           ///< the device's against double
  double apart = 0.0;  ///< the device's floats against the CPU's, ulp
};

/// Measures over `count` evaluations of evaluate.h; the components of a formula count together. With `gpu` it also
/// measures the first Vulkan device, and writes its name to `device`.
std::vector<Measured> measure(std::size_t count, bool gpu, std::string& device);

}  // namespace welkin::numerics
