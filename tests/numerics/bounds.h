// SPDX-License-Identifier: Apache-2.0
// Bounds of the shared formulas' errors: the measured error plus a tenth, which leaves room for other versions of the C
// library and of Mesa.
#pragma once

#include <string_view>
#include <vector>

namespace welkin::numerics {

/// Bounds of one formula, in units of the last place.
struct Bound {
  std::string_view formula;
  double floats;  ///< on the CPU
  double gpu;     ///< on lavapipe
};

const std::vector<Bound>& bounds();

}  // namespace welkin::numerics
