// SPDX-License-Identifier: Apache-2.0
// What a rough surface reflects of an even light, against quadrature, and the furnace that it makes with a diffuse
// part.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "furnace.h"
#include "materials.h"

namespace welkin::tests {
namespace {

using f64::Number3;

// Between the nodes of the fit, too.
constexpr std::array kCosines = {1e-4, 0.005, 0.013, 0.027, 0.043, 0.06, 0.088, 0.12, 0.17, 0.22,
                                 0.28, 0.35,  0.45,  0.55,  0.684, 0.77, 0.86,  0.95, 1.0};

struct Integrals {
  double white, schlick;
};

Integrals integralsOf(double m, double cosine) {
  constexpr int kSteps = 300;  // halving them changes no integral by more than 2e-4
  const double view_rad = std::acos(cosine);
  return {furnace(m, view_rad, kSteps,
                  [&](const Number3& l, const Number3& v, const Number3& h) {
                    return f64::schlickSmithLobe(m, l.y, v.y, h.y);
                  }),
          furnace(m, view_rad, kSteps, [&](const Number3& l, const Number3& v, const Number3& h) {
            return f64::schlickShare(std::min(dot(h, v), 1.0)) * f64::schlickSmithLobe(m, l.y, v.y, h.y);
          })};
}

}  // namespace

TEST_CASE("ReflectedShare, IsTheIntegralOfTheLobe") {
  double worst_white = 0.0, worst_schlick = 0.0;
  for (int i = 0; i <= 27; ++i) {
    const double m = f64::powerOfGloss(i / 27.0);
    for (const double cosine : kCosines) {
      CAPTURE(m, cosine);
      const Integrals truth = integralsOf(m, cosine);
      const double white = f64::whiteShare(m, cosine);
      worst_white = std::max(worst_white, std::abs(white - truth.white));
      worst_schlick = std::max(worst_schlick, std::abs(white * f64::meanSchlickShare(m, cosine) - truth.schlick));
    }
  }
  CHECK(worst_white < 0.019);  // as stated beside the formulas
  CHECK(worst_schlick < 0.017);
}

TEST_CASE("ReflectedShare, AWhiteFurnaceGetsBackNoMoreThanArrives") {
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j <= 40; ++j) {
      const double m = f64::powerOfGloss(i / 40.0), cosine = j / 40.0;
      CAPTURE(m, cosine);
      for (const double metallic : {0.0, 0.5, 1.0}) {
        const Number3 base(1.0, 0.5, 0.0), c = f64::specularColourOf(base, metallic);
        const Number3 reflected = f64::reflectedShare(c, m, cosine), diffuse = f64::diffuseColourOf(base, metallic);
        for (int k = 0; k < 3; ++k) {
          REQUIRE(reflected[k] >= 0.0);
          REQUIRE(reflected[k] + diffuse[k] * (1.0 - reflected[k]) <= 1.0 + 1e-15);
        }
        // A white dielectric returns everything, whatever its gloss and the view.
        if (metallic == 0.0) REQUIRE(reflected.x + diffuse.x * (1.0 - reflected.x) == Approx(1.0).epsilon(1e-15));
      }
    }
}

TEST_CASE("ReflectedShare, HasSchlicksLimitOfAMirror") {
  for (const double cosine : {0.5, 0.7, 0.9, 1.0}) {
    const double c = 0.04, schlick = c + (1.0 - c) * f64::schlickShare(cosine);
    // Schlick-Smith's visibility loses about 2 a/n.v of it at gloss 1, a = 0.0125; the fit adds its error.
    CHECK(f64::reflectedShare(Number3(c), 8192.0, cosine).x == Approx(schlick).margin(0.05 * schlick + 0.017));
  }
}

TEST_CASE("OpenShare, IsNeverAboveTheOpenSkys") {
  CHECK(f64::openShareOf(2.0, 1.0) == 1.0);
  CHECK(f64::openShareOf(0.25, 1.0) == 0.25);
  CHECK(f64::openShareOf(0.0, 1.0) == 0.0);
  CHECK(f64::openShareOf(-1.0, 1.0) == 0.0);
  CHECK(f64::openShareOf(1.0, 0.0) == 0.0);
  CHECK(f64::openShareOf(0.0, 0.0) == 0.0);
  const Number3 share = f64::openShare(Number3(0.1, 2.0, 0.3), Number3(1.0, 1.0, 0.6));
  CHECK(share.x == 0.1);
  CHECK(share.y == 1.0);
  CHECK(share.z == 0.5);
}

TEST_CASE("MaterialOfGltf, IsDielectricOrMetal") {
  const Number3 base(0.9, 0.6, 0.1);
  CHECK(f64::specularColourOf(base, 0.0) == Number3(0.04));
  CHECK(f64::specularColourOf(base, 1.0) == base);
  CHECK(f64::diffuseColourOf(base, 0.0) == base);
  CHECK(f64::diffuseColourOf(base, 1.0) == Number3(0.0));
}

TEST_CASE("MipOfGloss, IsTheInverseOfGlossOfMip") {
  for (const double mips : {2.0, 7.0, 9.0})
    for (double mip = 0.0; mip < mips; mip += 0.5)
      CHECK(f64::mipOfGloss(f64::glossOfMip(mip, mips), mips) == Approx(mip).margin(1e-12));
  CHECK(f64::mipOfGloss(1.0, 7.0) == 0.0);
  CHECK(f64::mipOfGloss(0.0, 7.0) == 6.0);
}

}  // namespace welkin::tests
