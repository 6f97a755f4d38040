// SPDX-License-Identifier: Apache-2.0
// Microfacet specular reflection: closed forms, furnace, reciprocity and extremes. Values are of the calibration notes'
// sections 3.2 and 5.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "furnace.h"
#include "materials.h"

namespace welkin::tests {
namespace {

using f64::Number3;

constexpr double kPrinted = 2e-5;  // relative: the digits of the notes' tables
constexpr std::array kPowers = {1.0, 2.0, 8.0, 64.0, 1024.0, 8192.0};

/// Lobe under V = 1.
double openLobe(double m, const Number3& l, const Number3& v, const Number3& h) {
  return f64::factoredLobe(f64::linearFactor(m, 1.0, 2.0), m, l.y, v.y, h.y);
}

double fullLobe(double m, const Number3& l, const Number3& v, const Number3& h) {
  return f64::schlickSmithLobe(m, l.y, v.y, h.y);
}

double shippedLobe(double m, const Number3& l, const Number3& v, const Number3& h) {
  return f64::factoredLobe(f64::shippedFactor(m), m, l.y, v.y, h.y);
}

template <typename Lobe>
double furnaceOf(Lobe&& lobe, double m, double view_deg, int steps = 1200) {
  return furnace(m, view_deg * f64::kDegree, steps,
                 [&](const Number3& l, const Number3& v, const Number3& h) { return lobe(m, l, v, h); });
}

Number3 randomDirection(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const Number3 d{normal(random), normal(random), normal(random)};
  return d / std::sqrt(dot(d, d));
}

}  // namespace

TEST_CASE("Specular, FactorsOfTheNotesTable") {
  struct Row {
    double g, m, a, visibility, mean, fitted, eight, four, shipped, one;
  };
  constexpr std::array<Row, 7> kRows = {{
      {0.0, 1.0, 0.651470, 1.51171, 0.56689, 0.27607, 0.3750, 0.3750, 0.3750, 0.3750},
      {0.1, 2.4623, 0.534166, 1.81192, 1.01067, 0.84636, 1.8373, 1.1061, 0.7406, 0.5578},
      {0.25, 9.5137, 0.332543, 2.72093, 3.91597, 4.54320, 8.8887, 4.6318, 2.5034, 1.4392},
      {0.5, 90.5097, 0.117317, 5.89365, 68.15240, 74.76598, 89.8847, 45.1298, 22.7524, 11.5637},
      {0.75, 861.0779, 0.038409, 11.48981, 1239.57570, 1230.39856, 860.4529, 430.4140, 215.3945, 107.8847},
      {0.9, 3326.9858, 0.019557, 16.10344, 6701.01534, 6604.66650, 3326.3608, 1663.3679, 831.8715, 416.1232},
      {1.0, 8192.0, 0.012465, 19.71489, 20192.97166, 20248.25555, 8191.3750, 4095.8750, 2048.1250, 1024.2500},
  }};
  for (const Row& row : kRows) {
    CAPTURE(row.g);
    const double m = f64::powerOfGloss(row.g), a = f64::smithRoughness(m);
    REQUIRE(m == Approx(row.m).epsilon(kPrinted));
    REQUIRE(a == Approx(row.a).epsilon(5e-5));
    REQUIRE(f64::meanVisibility(a) == Approx(row.visibility).epsilon(kPrinted));
    REQUIRE(f64::meanFactor(row.g) == Approx(row.mean).epsilon(kPrinted));
    REQUIRE(f64::fittedFactor(row.g) == Approx(row.fitted).epsilon(kPrinted));
    REQUIRE(f64::linearFactor(m, 8.0, -5.0) == Approx(row.eight).epsilon(1e-4));
    REQUIRE(f64::linearFactor(m, 4.0, -1.0) == Approx(row.four).epsilon(1e-4));
    REQUIRE(f64::shippedFactor(m) == Approx(row.shipped).epsilon(1e-4));
    REQUIRE(f64::linearFactor(m, 1.0, 2.0) == Approx(row.one).epsilon(1e-4));
  }
}

TEST_CASE("Specular, TheShippedFactorIsBelowTheMeanAndOthersAreNot") {
  double least = 10.0, most = 0.0, worst_eight = 0.0, worst_four = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    const double g = i / 1000.0, m = f64::powerOfGloss(g), mean = f64::meanFactor(g);
    least = std::min(least, f64::shippedFactor(m) / mean);
    most = std::max(most, f64::shippedFactor(m) / mean);
    worst_eight = std::max(worst_eight, f64::linearFactor(m, 8.0, -5.0) / mean);
    worst_four = std::max(worst_four, f64::linearFactor(m, 4.0, -1.0) / mean);
    REQUIRE(f64::linearFactor(m, 1.0, 2.0) / mean < 0.67);
  }
  REQUIRE(least == Approx(0.101).margin(1e-3));
  REQUIRE(most == Approx(0.735).margin(1e-3));
  REQUIRE(worst_eight == Approx(2.31).margin(0.01));
  REQUIRE(worst_four == Approx(1.23).margin(0.01));
}

TEST_CASE("Specular, TheMeanVisibilityIsTheDoubleMean") {
  // Means over both hemispheres by a midpoint rule in the cosines, in which the measure is uniform.
  constexpr int kSteps = 2000;
  for (const double a : {0.05, 0.2, 0.651470, 0.995, 1.0 - 1e-9, 1.0}) {
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) sum += 1.0 / ((i + 0.5) / kSteps * (1.0 - a) + a);
    const double mean = sum / kSteps;
    REQUIRE(f64::meanVisibility(a) == Approx(mean * mean).epsilon(1e-4));
    // The product is separable, so one double sum is enough to see it.
    REQUIRE(f64::schlickSmith(a, 0.3, 0.6) == Approx(1.0 / ((0.3 * (1.0 - a) + a) * (0.6 * (1.0 - a) + a))));
  }
  REQUIRE(f64::meanVisibility(1.0) == 1.0);
  // Both sides of the change to the series: 0.01^3/2 of the value between them.
  REQUIRE(f64::meanVisibility(0.99 + 1e-9) == Approx(f64::meanVisibility(0.99 - 1e-9)).epsilon(1e-6));
}

TEST_CASE("Specular, TheDistributionIsNormalised") {
  for (const double m : kPowers) {
    constexpr int kSteps = 200000;
    double projected = 0.0, whole = 0.0;
    for (int i = 0; i < kSteps; ++i) {
      const double angle = f64::kHalfPi * (i + 0.5) / kSteps;
      const double share = f64::blinnPhong(m, std::cos(angle)) * f64::kTwoPi * std::sin(angle) * f64::kHalfPi / kSteps;
      projected += share * std::cos(angle);
      whole += share;
    }
    REQUIRE(projected == Approx(1.0).epsilon(1e-6));
    REQUIRE(whole == Approx((m + 2.0) / (m + 1.0)).epsilon(1e-6));
  }
}

TEST_CASE("Specular, VisibilityIsGeometryOverBothCosines") {
  for (const double m : kPowers) {
    const double a = f64::smithRoughness(m);
    REQUIRE(a == Approx(std::sqrt(2.0 / (m + 2.0)) * std::sqrt(2.0 / f64::kPi)).epsilon(1e-12));
    REQUIRE(f64::schlickSmith(a, 1.0, 1.0) == Approx(1.0).epsilon(1e-12));
    REQUIRE(f64::schlickSmith(a, 0.0, 0.0) == Approx(1.0 / (a * a)).epsilon(1e-12));
    for (const double l : {0.0, 0.1, 0.5, 1.0})
      for (const double v : {0.0, 0.1, 0.5, 1.0}) {
        REQUIRE(f64::schlickSmith(a, l, v) == Approx(f64::schlickSmith(a, v, l)).epsilon(1e-14));
        REQUIRE(f64::schlickSmith(a, l, v) * l * v <= 1.0 + 1e-14);
      }
  }
}

TEST_CASE("Specular, FresnelsFormsAndTheirDistances") {
  double gaussian = 0.0, at = 0.0, later = 0.0, before = 2.0;
  for (int i = 0; i <= 1000; ++i) {
    const double x = i / 1000.0, exact = f64::schlickShare(x);
    if (const double away = std::abs(f64::gaussianShare(x) - exact); away > gaussian) {
      gaussian = away;
      at = x;
    }
    later = std::max(later, std::abs(f64::laterGaussianShare(x) - exact));
    REQUIRE(f64::gaussianShare(x) < before);
    before = f64::gaussianShare(x);
  }
  REQUIRE(gaussian == Approx(0.0417).margin(1e-4));
  REQUIRE(at == Approx(0.102).margin(2e-3));
  REQUIRE(later == Approx(0.0038).margin(2e-4));
  for (auto* share : {f64::schlickShare, f64::gaussianShare, f64::laterGaussianShare}) REQUIRE(share(0.0) == 1.0);
  REQUIRE(f64::schlickShare(1.0) == 0.0);
  REQUIRE(f64::gaussianShare(1.0) == Approx(0.002479).margin(1e-6));
  REQUIRE(f64::fresnel(Number3(1.0), 0.3) == Number3(1.0));
  REQUIRE(f64::fresnel(Number3(0.04), 1.0).x == Approx(1.0));
}

TEST_CASE("Specular, FurnaceOnTheNormalInClosedForm") {
  const std::array<std::pair<double, double>, 7> kValues = {{{1.0, 0.2 + 0.4 / std::sqrt(8.0)},
                                                             {2.0, 5.0 / 12.0},
                                                             {4.0, 17.0 / 32.0},
                                                             {16.0, 0.800195},
                                                             {64.0, 0.941176},
                                                             {1024.0, 0.996109},
                                                             {8192.0, 0.999512}}};
  for (const auto& [m, value] : kValues) {
    CAPTURE(m);
    REQUIRE(furnaceAtNormal(m) == Approx(value).epsilon(2e-6));
    // The cut of the hemisphere's edge in steps: 1e-3 for m = 1, for which half vectors reach 45 degrees.
    REQUIRE(furnaceOf(openLobe, m, 0.0) == Approx(value).epsilon(1e-3));
    REQUIRE(furnaceOf(shippedLobe, m, 0.0) == Approx(value * (2.0 * m + 1.0) / (m + 2.0)).epsilon(1e-3));
  }
}

TEST_CASE("Specular, FurnaceOffTheNormal") {
  // The notes' table for m = 64 under Schlick-Smith.
  constexpr std::array<std::pair<double, double>, 6> kTable = {
      {{0.0, 0.991}, {30.0, 0.947}, {45.0, 0.878}, {60.0, 0.746}, {75.0, 0.516}, {85.0, 0.332}}};
  for (const auto& [angle, value] : kTable) REQUIRE(furnaceOf(fullLobe, 64.0, angle) == Approx(value).margin(1e-3));
  // The mirror's limit: cos^2 for V = 1, twice that as shipped. 8192 leaves 1/m tan^2 of it.
  for (const double angle : {0.0, 30.0, 45.0, 60.0}) {
    const double cosine = std::cos(angle * f64::kDegree);
    REQUIRE(furnaceOf(openLobe, 8192.0, angle) == Approx(cosine * cosine).epsilon(2e-3));
    REQUIRE(furnaceOf(shippedLobe, 8192.0, angle) == Approx(2.0 * cosine * cosine).epsilon(2e-3));
  }
}

TEST_CASE("Specular, SchlickSmithConservesEnergyAndTheShippedFactorDoesNot") {
  for (const double m : kPowers)
    for (const double angle : {0.0, 20.0, 40.0, 60.0, 75.0, 85.0, 89.0}) {
      CAPTURE(m, angle);
      REQUIRE(furnaceOf(fullLobe, m, angle, 600) <= 1.0 + 1e-3);
    }
  REQUIRE(furnaceOf(shippedLobe, 4.0, 0.0) == Approx(0.797).margin(1e-3));
  REQUIRE(furnaceOf(shippedLobe, 8.0, 0.0) == Approx(1.142).margin(2e-3));
  // Half of the light is the most that the shipped factor can be given: the notes' 0.499.
  REQUIRE(0.499 * furnaceOf(shippedLobe, 8192.0, 0.0) < 1.0);
  REQUIRE(0.51 * furnaceOf(shippedLobe, 8192.0, 0.0) > 1.0);
}

TEST_CASE("Specular, ReciprocalAndNeverNegative") {
  std::mt19937 random(11);
  for (int i = 0; i < 2000; ++i) {
    const Number3 n = randomDirection(random), l = randomDirection(random), v = randomDirection(random);
    const double m = kPowers[static_cast<std::size_t>(i) % kPowers.size()];
    for (auto* specular : {f64::shippedSpecular, f64::schlickSmithSpecular}) {
      const Number3 there = specular({0.04, 0.5, 1.0}, m, n, l, v), back = specular({0.04, 0.5, 1.0}, m, n, v, l);
      const bool front = dot(n, l) > 0.0 && dot(n, v) > 0.0;
      for (int c = 0; c < 3; ++c) {
        REQUIRE(there[c] == Approx(back[c]).epsilon(1e-9));  // h.l and h.v round apart
        REQUIRE(there[c] >= 0.0);
        if (!front) REQUIRE(there[c] == 0.0);
      }
    }
  }
}

TEST_CASE("Specular, ExtremesGiveNumbers") {
  const std::array<f32::Number3, 7> directions = {{{0.0F, 1.0F, 0.0F},
                                                   {0.0F, -1.0F, 0.0F},
                                                   {1.0F, 0.0F, 0.0F},
                                                   {-1.0F, 0.0F, 0.0F},
                                                   {1.0F, 1e-7F, 0.0F},
                                                   {0.0F, 0.0F, 0.0F},
                                                   {-1.0F, 1e-38F, 0.0F}}};
  for (const auto& n : directions)
    for (const auto& l : directions)
      for (const auto& v : directions)
        for (const float g : {0.0F, 0.5F, 1.0F})
          for (const float c : {0.0F, 0.04F, 1.0F}) {
            const float m = f32::powerOfGloss(g);
            for (auto* specular : {f32::shippedSpecular, f32::schlickSmithSpecular}) {
              const float value = specular(f32::Number3(c), m, n, l, v).x;
              REQUIRE(std::isfinite(value));
              REQUIRE(value >= 0.0F);
            }
          }
}

}  // namespace welkin::tests
