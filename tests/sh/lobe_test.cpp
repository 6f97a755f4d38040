// SPDX-License-Identifier: Apache-2.0
// The zonal factors: the clipped cosine that makes irradiance, and the lower hemisphere that makes the ground.
#include <catch2/catch.hpp>
#include <cmath>

#include "sh/deterministic.h"
#include "sh/quadrature.h"

namespace welkin::sh {
namespace {

/// 2 pi times the integral of f(x) P_l(x) over [a, b]: the Funk-Hecke factor of a zonal function.
template <typename F>
double zonalFactor(int l, double a, double b, F&& f) {
  double sum = 0.0;
  forEachNode(gaussLegendre(12), a, b,
              [&](double x, double w) { sum += w * f(x) * std::legendre(static_cast<unsigned>(l), x); });
  return 2.0 * M_PI * sum;
}

TEST_CASE("CosineLobe, FactorsAreTheIntegrals") {
  for (int l = 0; l < 5; ++l)
    CHECK(det::cosineLobe(l) == Approx(zonalFactor(l, 0.0, 1.0, [](double x) { return x; })).margin(1e-14));
}

TEST_CASE("GroundLobe, FactorsAreTheIntegrals") {
  for (int l = 0; l < 5; ++l)
    CHECK(det::groundLobe(l) == Approx(zonalFactor(l, -1.0, 0.0, [](double) { return 1.0; })).margin(1e-14));
}

TEST_CASE("CosineLobe, ProjectionOfACosine") {
  // L = max(y, 0): c0 = sqrt(pi)/2, c1(y) = sqrt(pi/3), and zonal c2 = sqrt(5 pi)/8 about y.
  const auto up = det::shBasis({0.0, 1.0, 0.0});
  CHECK(det::cosineLobe(0) * up.v[0] == Approx(0.8862269254527580).epsilon(1e-14));
  CHECK(det::cosineLobe(1) * up.v[1] == Approx(1.0233267079464885).epsilon(1e-14));
  // About y the second band has two coefficients: their norm is that of the zonal one.
  const double second = det::cosineLobe(2) * std::hypot(up.v[6], up.v[8]);
  CHECK(second == Approx(0.4954159122007463).epsilon(1e-13));
}

}  // namespace
}  // namespace welkin::sh
