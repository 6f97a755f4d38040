// SPDX-License-Identifier: Apache-2.0
// The light that a white furnace gets back from a lobe, by converged quadrature.
#pragma once

#include <algorithm>
#include <cmath>

#include "materials.h"

namespace welkin::tests {

/// Integral of lobe(l, v, h) (n.l) over light directions l for a viewer at an angle from the normal, n = +y. It runs
/// over half vectors, dw_l = 4 (v.h) dw_h, so a sharp lobe keeps its nodes: a midpoint rule in the angle from the
/// normal, cut where (n.h)^m is below 1e-16, and a trapezium rule around it. `steps` along either.
template <typename Lobe>
double furnace(double m, double view_rad, int steps, Lobe&& lobe) {
  using f64::Number3;
  const Number3 n{0.0, 1.0, 0.0}, v{std::sin(view_rad), std::cos(view_rad), 0.0};
  const double widest = std::acos(std::pow(1e-16, 1.0 / m));
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double angle = widest * (i + 0.5) / steps;
    for (int j = 0; j < steps; ++j) {
      const double turn = f64::kTwoPi * (j + 0.5) / steps;
      const Number3 h{std::sin(angle) * std::cos(turn), std::cos(angle), std::sin(angle) * std::sin(turn)};
      const double h_dot_v = dot(h, v);
      if (h_dot_v <= 0.0) continue;
      const Number3 l = h * (2.0 * h_dot_v) - v;
      if (dot(n, l) <= 0.0) continue;
      sum += lobe(l, v, h) * dot(n, l) * 4.0 * h_dot_v * std::sin(angle);
    }
  }
  return sum * widest / steps * f64::kTwoPi / steps;
}

/// The same in closed form for V = 1 and the viewer on the normal.
inline double furnaceAtNormal(double m) {
  return (m + 2.0) * (2.0 * (1.0 - std::pow(2.0, -(m + 4.0) / 2.0)) / (m + 4.0) -
                      (1.0 - std::pow(2.0, -(m + 2.0) / 2.0)) / (m + 2.0));
}

}  // namespace welkin::tests
