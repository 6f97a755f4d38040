// SPDX-License-Identifier: Apache-2.0
// What the errors of the shared formulas are held to: what was measured and a tenth, for other versions of the C
// library and of Mesa.
#pragma once

#include <string_view>
#include <vector>

namespace welkin::numerics {

/// Units of the last place.
struct Bound {
  std::string_view formula;
  double floats;  ///< the CPU's
  double gpu;     ///< lavapipe's
};

const std::vector<Bound>& bounds();

}  // namespace welkin::numerics
