// SPDX-License-Identifier: Apache-2.0
// The mean of light over a reflected lobe by the runtime's rule, as shaders/passes/reflection.comp sums it.
#pragma once

#include "materials.h"

namespace welkin::tests {

/// Mean over the lobe of `power` about a unit axis. `dome` is called above the horizon alone; `ground` is the radiance
/// below.
template <typename Dome>
f64::Number3 lobeMean(Dome&& dome, const f64::Number3& ground, double power, const f64::Number3& axis) {
  const int out = f64::lobePanelsOut(power), around = f64::lobePanelsAround(power);
  f64::Number3 sum(0.0);
  double total = 0.0;
  for (int i = 0; i < 8 * out; ++i) {
    const f64::LobeCircle circle = f64::lobeCircle(power, axis, i, out);
    const double above = circle.turn / f64::kPi;
    f64::Number3 light = ground * (1.0 - above);
    for (int j = 0; above > 0.0 && j < 4 * around; ++j)
      light += dome(f64::lobeDirection(circle, axis, j, around)) * (above * f64::gaussWeight(j % 4) / (2.0 * around));
    sum += light * circle.weight;
    total += circle.weight;
  }
  return sum / total;
}

}  // namespace welkin::tests
