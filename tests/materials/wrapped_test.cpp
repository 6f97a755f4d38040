// SPDX-License-Identifier: Apache-2.0
// Wrapped diffuse light: its energy over the sphere in closed form, its zonal factors and its limits.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "materials.h"

namespace welkin::tests {
namespace {

constexpr double kQuadrature = 2e-6;  // of a midpoint rule of 1e5 nodes over a kernel with one kink

/// 1/pi times the integral of kernel(cosine) p(cosine) over the sphere, of the cosines above `least`.
template <typename Kernel, typename Weight>
double sphere(Kernel&& kernel, Weight&& weight, double least = -1.0) {
  constexpr int kNodes = 100000;
  double sum = 0.0;
  for (int i = 0; i < kNodes; ++i) {
    const double cosine = least + (1.0 - least) * (i + 0.5) / kNodes;
    sum += kernel(cosine) * weight(cosine);
  }
  return sum * (1.0 - least) / kNodes * 2.0;
}

double one(double) {
  return 1.0;
}

}  // namespace

TEST_CASE("Wrapped, EveryWrapAndPowerReflectsAsMuchAsLambert") {
  for (const double w : {0.0, 0.25, 0.5, 1.0}) {
    REQUIRE(sphere([&](double x) { return f64::wrappedDiffuse(x, w); }, one) == Approx(1.0).epsilon(kQuadrature));
    for (const double n : {0.5, 1.0, 2.0, 4.0, 50.0}) {
      CAPTURE(w, n);
      // The kink of a root is worth 1e-4 of the rule.
      REQUIRE(sphere([&](double x) { return f64::wrappedDiffusePower(x, w, n); }, one) ==
              Approx(1.0).epsilon(n < 1.0 ? 1e-4 : 1e-5));
      REQUIRE(sphere([&](double x) { return f64::wrappedPower(x, w, n); }, one) ==
              Approx(2.0 * (1.0 + w) / (n + 1.0)).epsilon(n < 1.0 ? 1e-4 : 1e-5));
    }
  }
}

TEST_CASE("Wrapped, ThePowerOneIsTheLinearForm") {
  for (const double w : {-1.0, 0.0, 0.3, 1.0, 3.0})
    for (const double x : {-1.0, -0.31, -0.3, 0.0, 0.5, 1.0})
      REQUIRE(f64::wrappedDiffusePower(x, w, 1.0) == Approx(f64::wrappedDiffuse(x, w)).margin(1e-15));
  for (const double x : {-0.5, 0.0, 0.5, 1.0}) REQUIRE(f64::wrappedDiffuse(x, 0.0) == std::max(x, 0.0));
}

TEST_CASE("Wrapped, PeaksAndTheShareOfTheUpperHemisphere") {
  REQUIRE(f64::wrappedDiffuse(1.0, 0.5) == Approx(1.0 / 1.5));
  REQUIRE(f64::wrappedDiffusePower(1.0, 1.0, 2.0) == Approx(0.75));                   // half-Lambert, normalised
  REQUIRE(f64::wrappedDiffusePower(1.0, 0.5, 1.5) == Approx(0.83333).epsilon(1e-5));  // Sloan, a = 0.5
  REQUIRE(f64::wrappedDiffusePower(1.0, 0.5, 4.0) == Approx(1.66667).epsilon(1e-5));
  for (const double w : {0.5, 1.0})
    for (const double n : {1.0, 4.0})
      REQUIRE(sphere([&](double x) { return f64::wrappedDiffusePower(x, w, n); }, one, 0.0) ==
              Approx(1.0 - std::pow(w / (1.0 + w), n + 1.0)).epsilon(1e-5));
}

TEST_CASE("Wrapped, ZonalFactorsOfTheLinearForm") {
  for (const double w : {0.0, 0.25, 0.5, 1.0}) {
    const auto kernel = [&](double x) { return f64::wrappedDiffuse(x, w); };
    REQUIRE(sphere(kernel, [](double x) { return x; }) == Approx((2.0 - w) / 3.0).epsilon(1e-5));
    REQUIRE(sphere(kernel, [](double x) { return (3.0 * x * x - 1.0) / 2.0; }) ==
            Approx((1.0 - w) * (1.0 - w) / 4.0).margin(1e-5));
  }
}

TEST_CASE("Wrapped, OlderFormsReflectMoreThanArrives") {
  REQUIRE(sphere(f64::halfLambert, one) == Approx(4.0 / 3.0).epsilon(kQuadrature));
  for (const double a : {0.0, 0.5, 1.0})
    REQUIRE(sphere([&](double x) { return f64::sloanWrapped(x, a); }, one) ==
            Approx(2.0 * (1.0 + a) / (2.0 + a)).epsilon(1e-5));
  for (const double x : {-1.0, -0.2, 0.4, 1.0}) REQUIRE(f64::halfLambert(x) == Approx((x + 1.0) * (x + 1.0) / 4.0));
}

TEST_CASE("Wrapped, ChannelsOfSkinWrapOnTheirOwn") {
  const f64::Number3 skin = f64::wrappedDiffuseOf(-0.2, {0.5, 0.25, 0.1});
  REQUIRE(skin.x == f64::wrappedDiffuse(-0.2, 0.5));
  REQUIRE(skin.y == f64::wrappedDiffuse(-0.2, 0.25));
  REQUIRE(skin.z == 0.0);
}

TEST_CASE("Wrapped, LimitsGiveNumbers") {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const float w : {-1.0F, 0.0F, 1e-30F, 0.5F, 1.0F, 7.0F})
    for (const float n : {-2.0F, -1.0F, -0.999999F, 0.0F, 1e-30F, 1.0F, 1e6F, 1e30F, kInfinity})
      for (const float x : {-1.0F, -0.5F, -1e-30F, 0.0F, 1e-38F, 1e-30F, 0.5F, 1.0F - 0x1p-24F, 1.0F}) {
        CAPTURE(w, n, x);
        const float value = f32::wrappedDiffusePower(x, w, n);
        REQUIRE(std::isfinite(value));
        REQUIRE(value >= 0.0F);
        REQUIRE(std::isfinite(f32::wrappedDiffuse(x, w)));
      }
  REQUIRE(f32::wrappedDiffusePower(0.5F, 0.5F, -1.0F) == 0.0F);
  REQUIRE(f32::wrappedDiffusePower(-0.5F, 0.0F, 0.0F) == 0.0F);  // pow(0, 0) would light the dark side
  REQUIRE(f32::wrappedDiffusePower(0.5F, 0.0F, 0.0F) == 0.5F);
  REQUIRE(f32::wrappedDiffusePower(0.5F, 0.5F, 1e6F) == 0.0F);
}

}  // namespace welkin::tests
