// SPDX-License-Identifier: Apache-2.0
#include "probes/geometry/directions.h"

#include <catch2/catch.hpp>

#include "probes/geometry/random.h"

namespace welkin::tests {

using f64::Number3;
namespace {

constexpr int kCount = 200000;

}  // namespace

TEST_CASE("Directions, SphereIsUniform") {
  geometry::Random random(1);
  Number3 mean(0.0);
  Number3 square(0.0);
  for (int i = 0; i < kCount; ++i) {
    const double s = random.unit();
    const Number3 d = geometry::sphereDirection(s, random.unit());
    CHECK(dot(d, d) == Approx(1.0).epsilon(1e-14));
    mean += d * (1.0 / kCount);
    square += d * d * (1.0 / kCount);
  }
  for (int c = 0; c < 3; ++c) {
    CHECK(mean[c] == Approx(0.0).margin(4.0 * 0.577 / std::sqrt(kCount)));          // 4 standard errors, uniform in +-1
    CHECK(square[c] == Approx(1.0 / 3.0).margin(4.0 * 0.298 / std::sqrt(kCount)));  // of its square
  }
}

TEST_CASE("Directions, CosineAboutAnyNormal") {
  for (const Number3& n : {Number3(0, 1, 0), Number3(0, 0, -1), Number3(0, 0, 1), geometry::unit(Number3(-3, 1, -1e-9)),
                           geometry::unit(Number3(1, -2, 3))}) {
    geometry::Random random(2);
    double cosine = 0.0;
    Number3 mean(0.0);
    for (int i = 0; i < kCount; ++i) {
      const double s = random.unit();
      const Number3 d = geometry::cosineDirection(n, s, random.unit());
      CHECK(dot(d, d) == Approx(1.0).epsilon(1e-12));
      CHECK(dot(d, n) > 0.0);
      cosine += dot(d, n) / kCount;
      mean += d * (1.0 / kCount);
    }
    CHECK(cosine == Approx(2.0 / 3.0).margin(4.0 * 0.2357 / std::sqrt(kCount)));  // deviation sqrt(1/18)
    for (int c = 0; c < 3; ++c) CHECK(mean[c] == Approx(n[c] * 2.0 / 3.0).margin(4.0 * 0.5 / std::sqrt(kCount)));
  }
}

}  // namespace welkin::tests
