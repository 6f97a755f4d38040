// SPDX-License-Identifier: Apache-2.0
#include "sh/quadrature.h"

#include "sh/deterministic.h"

namespace welkin::sh {

GaussRule gaussLegendre(int n) {
  GaussRule rule{std::vector<double>(static_cast<std::size_t>(n)), std::vector<double>(static_cast<std::size_t>(n))};
  for (int i = 0; i < n; ++i) {
    double x = -det::cos(det::kPi * (i + 0.75) / (n + 0.5));
    double derivative = 1.0;
    for (int iteration = 0; iteration < 8; ++iteration) {  // quadratic from three digits: four steps reach rounding
      double before = 1.0;
      double value = x;
      for (int k = 2; k <= n; ++k) {
        const double next = ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k;
        before = value;
        value = next;
      }
      derivative = n * (x * value - before) / (x * x - 1.0);
      x -= value / derivative;
    }
    rule.node[static_cast<std::size_t>(i)] = x;
    rule.weight[static_cast<std::size_t>(i)] = 2.0 / ((1.0 - x * x) * derivative * derivative);
  }
  return rule;
}

}  // namespace welkin::sh
