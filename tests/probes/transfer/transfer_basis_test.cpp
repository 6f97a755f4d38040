// SPDX-License-Identifier: Apache-2.0
#include "probes/transfer/transfer_basis.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace welkin::tests {

using f64::Number3;

TEST_CASE("TransferBasis, ThreeOrthonormalDirectionsUpAndOneDown") {
  const auto basis = transfer::transferBasis();
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) CHECK(dot(basis[i], basis[j]) == Approx(i == j ? 1.0 : 0.0).margin(1e-15));
  for (std::size_t i = 0; i < 3; ++i) CHECK(basis[i].y == Approx(1.0 / std::sqrt(3.0)));
  CHECK(basis[3] == Number3(0, -1, 0));
}

TEST_CASE("TransferBasis, WeightsAreExactForWhatIsLinearInTheNormal") {
  const auto basis = transfer::transferBasis();
  const Number3 slope(0.3, -0.7, 1.9);
  for (const Number3& n : {Number3(0, 1, 0), Number3(0, -1, 0), Number3(0.6, 0, -0.8), Number3(-0.48, 0.6, 0.64)}) {
    const auto weight = transfer::shadingWeights(n);
    double sum = 0.0;
    double value = 0.0;
    for (std::size_t i = 0; i < transfer::kDirections; ++i) {
      sum += weight[i];
      value += weight[i] * (2.0 + dot(slope, basis[i]));
    }
    CHECK(sum == Approx(1.0).epsilon(1e-14));
    CHECK(value == Approx(2.0 + dot(slope, n)).epsilon(1e-14));
  }
}

}  // namespace welkin::tests
