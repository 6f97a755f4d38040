// SPDX-License-Identifier: Apache-2.0
// Gauss-Legendre rules against the integrals that they must give exactly.
#include "sh/quadrature.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace welkin::sh {
namespace {

constexpr double kSumRounding = 1e-14;  // a few units in the last place of sums of up to 64 terms of size 1

TEST_CASE("GaussLegendre, ExactForPolynomials") {
  for (const int n : {1, 2, 3, 5, 8, 24, 64}) {
    const GaussRule rule = gaussLegendre(n);
    for (int degree = 0; degree <= 2 * n - 1; ++degree) {
      double sum = 0.0;
      forEachNode(rule, -1.0, 1.0, [&](double x, double w) { sum += w * std::pow(x, degree); });
      CAPTURE(n, degree);
      CHECK(sum == Approx(degree % 2 == 0 ? 2.0 / (degree + 1) : 0.0).margin(kSumRounding));
    }
  }
}

TEST_CASE("GaussLegendre, OneDegreeMoreIsNotExact") {
  const GaussRule rule = gaussLegendre(3);
  double sum = 0.0;
  forEachNode(rule, -1.0, 1.0, [&](double x, double w) { sum += w * std::pow(x, 6); });
  CHECK(std::abs(sum - 2.0 / 7.0) > 1e-3);
}

TEST_CASE("GaussLegendre, MapsToAnyInterval") {
  double sum = 0.0;
  forEachNode(gaussLegendre(8), 1.0, 3.0, [&](double x, double w) { sum += w * std::exp(x); });
  CHECK(sum == Approx(std::exp(3.0) - std::exp(1.0)).epsilon(1e-13));
}

}  // namespace
}  // namespace welkin::sh
