// SPDX-License-Identifier: Apache-2.0
// Gloss, roughness, power and Toksvig's formula, as floats and as doubles.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "materials.h"

namespace welkin::tests {

TEST_CASE("Gloss, PowersOfTheNotesTable") {
  // m = 2^(13 g), calibration notes 3.2
  for (const auto& [g, m] : {std::pair(0.0, 1.0),
                             {0.1, 2.4623},
                             {0.25, 9.5137},
                             {0.5, 90.5097},
                             {0.75, 861.0779},
                             {0.9, 3326.9858},
                             {1.0, 8192.0}}) {
    REQUIRE(f64::powerOfGloss(g) == Approx(m).epsilon(2e-5));
    REQUIRE(f64::glossOfPower(f64::powerOfGloss(g)) == Approx(g).margin(1e-15));
    REQUIRE(f32::glossOfPower(f32::powerOfGloss(static_cast<float>(g))) == Approx(static_cast<float>(g)).margin(1e-6));
  }
  for (const double m : {-1.0, 0.0, 0.5}) REQUIRE(f64::glossOfPower(m) == 0.0);
  REQUIRE(f64::glossOfPower(1e30) == 1.0);
}

TEST_CASE("Gloss, RoughnessAndPowerHaveLobesOfOneWidth") {
  for (const double r : {0.2, 0.3, 0.5, 0.7, 0.9}) {
    const double m = f64::powerOfRoughness(r);
    REQUIRE(2.0 / (m + 2.0) == Approx(std::pow(r, 4.0)).epsilon(1e-12));
    REQUIRE(f64::roughnessOfPower(m) == Approx(r).epsilon(1e-12));
  }
  REQUIRE(f64::powerOfRoughness(0.0) == 8192.0);
  REQUIRE(f64::powerOfRoughness(1.0) == 1.0);
  REQUIRE(f32::powerOfRoughness(0.0F) == Approx(8192.0F));
}

TEST_CASE("Toksvig, VariancesAdd") {
  for (const double m : {1.0, 20.0, 512.0, 8192.0})
    for (const double na : {0.6, 0.9, 0.99, 0.9999, 1.0}) {
      const double lowered = f64::toksvigPower(m, na);
      REQUIRE(1.0 / lowered == Approx(std::min(1.0 / m + (1.0 - na) / na, 1.0)).epsilon(1e-12));
      REQUIRE(lowered <= m);
      REQUIRE(lowered >= 1.0);
    }
  // The order of two filters does not matter.
  REQUIRE(f64::toksvigPower(f64::toksvigPower(4000.0, 0.99), 0.97) ==
          Approx(f64::toksvigPower(f64::toksvigPower(4000.0, 0.97), 0.99)).epsilon(1e-12));
}

TEST_CASE("Toksvig, NoPoleAndNoNumberBelowOne") {
  for (const double na : {-1.0, 0.0, 1e-300, 1.0, 1.000122, 1.0063, 1e9}) {
    const double m = f64::toksvigPower(8192.0, na);
    CAPTURE(na);
    REQUIRE(m >= 1.0);
    REQUIRE(m <= 8192.0);
    const float single = f32::toksvigPower(8192.0F, static_cast<float>(na));
    REQUIRE(single >= 1.0F);
    REQUIRE(single <= 8192.0F);
  }
  REQUIRE(f64::toksvigPower(8192.0, 1.0) == 8192.0);
  REQUIRE(f64::toksvigPower(8192.0, 2.0) == 8192.0);
  REQUIRE(f64::toksvigPower(8192.0, 0.0) == 1.0);
}

}  // namespace welkin::tests
