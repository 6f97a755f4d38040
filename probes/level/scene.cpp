// SPDX-License-Identifier: Apache-2.0
#include "probes/level/scene.h"

#include <algorithm>

namespace welkin::level {

void Bounds::add(const f64::Number3& p) {
  for (int i = 0; i < 3; ++i) {
    low[i] = std::min(low[i], p[i]);
    high[i] = std::max(high[i], p[i]);
  }
}

}  // namespace welkin::level
