// SPDX-License-Identifier: Apache-2.0
// Rotated coefficients against the function evaluated in rotated directions.
#include "sh/rotation.h"

#include <catch2/catch.hpp>
#include <vector>

#include "sh/basis.h"

namespace welkin::sh {
namespace {

double evaluate(const std::vector<double>& c, const det::Number3& d) {
  std::vector<double> basis(c.size());
  evaluateBasis(LatitudeRecurrence(5), d, basis);
  double sum = 0.0;
  for (std::size_t i = 0; i < c.size(); ++i) sum += c[i] * basis[i];
  return sum;
}

std::vector<double> asymmetric() {
  std::vector<double> c(25);
  for (std::size_t i = 0; i < 25; ++i) c[i] = 1.0 - 0.13 * double(i) + (i % 3 == 0 ? 0.7 : 0.0);
  return c;
}

TEST_CASE("Rotation, MovesTheFunction") {
  const Matrix3 cyclic = {det::Number3(0, 0, 1), det::Number3(1, 0, 0), det::Number3(0, 1, 0)};
  const Matrix3 mirror = {det::Number3(-1, 0, 0), det::Number3(0, 1, 0), det::Number3(0, 0, 1)};
  const auto c = asymmetric();
  std::vector<double> rotated(25);
  for (const Matrix3& matrix : {azimuthRotation(0.8), azimuthRotation(-2.9), cyclic, mirror}) {
    Rotation(5, matrix).apply(c, rotated);
    for (const auto& d : {det::Number3(0.36, 0.48, 0.8), det::Number3(0.0, 1.0, 0.0), det::directionOf(4.0, -0.3)})
      CHECK(evaluate(rotated, d) == Approx(evaluate(c, apply(matrix, d))).margin(1e-13));
  }
}

TEST_CASE("AzimuthRotation, TurnsClockwiseSeenFromAbove") {
  // A sky whose light is in the north (-z), turned by 90 degrees, has it in the east (+x).
  std::vector<double> north(25, 0.0);
  north[2] = -1.0;
  std::vector<double> turned(25);
  Rotation(5, azimuthRotation(M_PI / 2.0)).apply(north, turned);
  CHECK(turned[3] == Approx(1.0).margin(1e-14));
  CHECK(turned[2] == Approx(0.0).margin(1e-14));
}

}  // namespace
}  // namespace welkin::sh
