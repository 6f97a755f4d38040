// SPDX-License-Identifier: Apache-2.0
// The basis: orthonormal, its order and signs, its two implementations against each other.
#include "sh/basis.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "sh/quadrature.h"

namespace welkin::sh {
namespace {

/// Integrates `f` over the sphere, exactly for polynomials of degree 15.
template <typename F>
double overSphere(F&& f) {
  constexpr int kAzimuths = 32;
  double sum = 0.0;
  forEachNode(gaussLegendre(16), -1.0, 1.0, [&](double z, double w) {
    for (int k = 0; k < kAzimuths; ++k) {
      const double phi = 2.0 * M_PI * (k + 0.25) / kAzimuths;
      const double c = std::sqrt(1.0 - z * z);
      sum += w * 2.0 * M_PI / kAzimuths * f(det::Number3(c * std::cos(phi), c * std::sin(phi), z));
    }
  });
  return sum;
}

TEST_CASE("ShBasis, GramMatrixIsIdentity") {
  constexpr double kRounding = 1e-13;  // of sums of 512 terms
  for (int i = 0; i < 25; ++i)
    for (int j = i; j < 25; ++j) {
      const double product = overSphere([&](const det::Number3& d) {
        const auto basis = det::shBasis(d);
        return basis.v[i] * basis.v[j];
      });
      CAPTURE(i, j);
      CHECK(product == Approx(i == j ? 1.0 : 0.0).margin(kRounding));
    }
}

TEST_CASE("ShBasis, OrderAndSignsOfTheConvention") {
  const auto basis = det::shBasis({0.3, 0.5, 0.8124038404635961});
  const double x = 0.3, y = 0.5, z = 0.8124038404635961;
  CHECK(basis.v[0] == Approx(0.5 / std::sqrt(M_PI)).epsilon(1e-14));
  CHECK(basis.v[1] == Approx(std::sqrt(3.0 / (4.0 * M_PI)) * y).epsilon(1e-14));
  CHECK(basis.v[2] == Approx(std::sqrt(3.0 / (4.0 * M_PI)) * z).epsilon(1e-14));
  CHECK(basis.v[3] == Approx(std::sqrt(3.0 / (4.0 * M_PI)) * x).epsilon(1e-14));
  const double second = 0.5 * std::sqrt(15.0 / M_PI);
  CHECK(basis.v[4] == Approx(second * x * y).epsilon(1e-14));
  CHECK(basis.v[5] == Approx(second * y * z).epsilon(1e-14));
  CHECK(basis.v[6] == Approx(second * (3.0 * z * z - 1.0) / (2.0 * std::sqrt(3.0))).epsilon(1e-14));
  CHECK(basis.v[7] == Approx(second * x * z).epsilon(1e-14));
  CHECK(basis.v[8] == Approx(second * (x * x - y * y) / 2.0).epsilon(1e-14));
}

TEST_CASE("EvaluateBasis, AgreesWithTheClosedForms") {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<double> general(25);
  for (int n = 0; n < 200; ++n) {
    det::Number3 d(normal(random), normal(random), normal(random));
    if (n < 6) {  // the poles of every axis
      d = det::Number3(0.0);
      d[n % 3] = n < 3 ? 1.0 : -1.0;
    }
    d = d / std::sqrt(dot(d, d));
    evaluateBasis(LatitudeRecurrence(5), d, general);
    const auto closed = det::shBasis(d);
    for (std::size_t i = 0; i < 25; ++i) {
      CAPTURE(d.x, d.y, d.z, i);
      REQUIRE(general[i] == Approx(closed.v[i]).margin(5e-15));
    }
  }
}

TEST_CASE("EvaluateBasis, AdditionTheoremAtManyBands") {
  // The squares of band l add up to (2 l + 1) / (4 pi) in every direction.
  constexpr int kBands = 40;
  std::vector<double> basis(kBands * kBands);
  for (const auto& d : {det::Number3(0.36, 0.48, 0.8), det::Number3(0.0, 0.0, -1.0), det::directionOf(2.0, 1e-9)}) {
    evaluateBasis(LatitudeRecurrence(kBands), d, basis);
    for (int l = 0; l < kBands; ++l) {
      double sum = 0.0;
      for (int m = -l; m <= l; ++m) {
        const double v = basis[static_cast<std::size_t>(indexOf(l, m))];
        sum += v * v;
      }
      CAPTURE(l);
      CHECK(sum == Approx((2.0 * l + 1.0) / (4.0 * M_PI)).epsilon(1e-12));
    }
  }
}

}  // namespace
}  // namespace welkin::sh
