// SPDX-License-Identifier: Apache-2.0
// Gauss-Legendre rules and their use over panels.
#pragma once

#include <vector>

namespace welkin::sh {

/// Nodes in (-1, 1), ascending, and weights, which add up to 2: exact for polynomials of degree 2 n - 1.
struct GaussRule {
  std::vector<double> node;
  std::vector<double> weight;
};

/// The rule with n >= 1 nodes, to about 1e-15: Newton's method on the Legendre polynomial (Press et al., "Numerical
/// Recipes", 2007, 4.6). Same bits on every machine.
GaussRule gaussLegendre(int n);

/// Calls visit(x, weight) for the rule's nodes mapped to [a, b]; the weights add up to b - a.
template <typename Visit>
void forEachNode(const GaussRule& rule, double a, double b, Visit&& visit) {
  const double half = 0.5 * (b - a);
  const double middle = 0.5 * (a + b);
  for (std::size_t i = 0; i < rule.node.size(); ++i) visit(middle + half * rule.node[i], half * rule.weight[i]);
}

}  // namespace welkin::sh
