// SPDX-License-Identifier: Apache-2.0
#include "probes/transfer_basis.h"

#include <cmath>

namespace welkin::probes {

std::array<Number3, kDirections> transferBasis() {
  const double up = std::sqrt(1.0 / 3.0);
  const double side = std::sqrt(0.5);
  const double back = -std::sqrt(1.0 / 6.0);
  return {Number3(std::sqrt(2.0 / 3.0), up, 0.0), Number3(back, up, side), Number3(back, up, -side),
          Number3(0.0, -1.0, 0.0)};
}

std::array<double, kDirections> shadingWeights(const Number3& normal) {
  const auto basis = transferBasis();
  std::array<double, kDirections> weight{};
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i) sum += weight[i] = dot(normal, basis[i]);
  const double root = std::sqrt(3.0);
  for (std::size_t i = 0; i < 3; ++i) weight[i] += (1.0 - sum) / (root * (1.0 + root));
  weight[3] = (1.0 - sum) / (1.0 + root);
  return weight;
}

}  // namespace welkin::probes
