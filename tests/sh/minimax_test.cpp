// SPDX-License-Identifier: Apache-2.0
// Minimax fits against classical closed forms, and against every set of points that can prove a bound.
#include "sh/minimax.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "sh/basis.h"
#include "tests/sh/bits.h"

namespace welkin::sh {
namespace {

constexpr double kRounding = 1e-12;  // of targets of size 1 and bases of condition 1e3
constexpr MinimaxLimits kTight{1e-12, 500};

/// Extrema of the Chebyshev polynomials of every degree that divides `intervals`, ascending.
std::vector<double> chebyshevPoints(int intervals) {
  std::vector<double> x;
  for (int i = intervals; i >= 0; --i) x.push_back(std::cos(M_PI * i / intervals));
  return x;
}

/// Chebyshev polynomials of degree 0 to columns - 1 at the points: a basis of all polynomials of that degree.
std::vector<double> polynomials(const std::vector<double>& x, std::size_t columns) {
  std::vector<double> basis;
  for (const double at : x)
    for (std::size_t k = 0; k < columns; ++k) basis.push_back(std::cos(double(k) * std::acos(at)));
  return basis;
}

template <typename Function>
std::vector<double> sample(const std::vector<double>& x, Function&& function) {
  std::vector<double> target;
  for (const double at : x) target.push_back(function(at));
  return target;
}

std::vector<double> errors(const std::vector<double>& basis, const MinimaxFit& fit, const std::vector<double>& target) {
  const std::size_t columns = fit.coefficient.size();
  std::vector<double> error = target;
  for (std::size_t i = 0; i < error.size(); ++i)
    for (std::size_t k = 0; k < columns; ++k) error[i] -= fit.coefficient[k] * basis[i * columns + k];
  return error;
}

double largestSize(const std::vector<double>& value) {
  double size = 0.0;
  for (const double x : value) size = std::max(size, std::abs(x));
  return size;
}

/// 642 evenly spread directions, from pole to pole.
std::vector<det::Number3> normals() {
  std::vector<det::Number3> direction;
  for (int i = 0; i < 642; ++i) {
    const double y = 1.0 - 2.0 * (i + 0.5) / 642.0;
    const double turn = 2.39996322972865332 * i;
    const double c = std::sqrt(1.0 - y * y);
    direction.emplace_back(c * std::cos(turn), c * std::sin(turn), y);
  }
  return direction;
}

TEST_CASE("Minimax, PowersByLowerDegrees") {
  const auto x = chebyshevPoints(5040);  // 1 to 10, 12, 14, 15 and 16 divide it
  for (const std::size_t n : {1u, 2u, 3u, 6u, 10u, 16u}) {
    const auto target = sample(x, [&](double at) { return std::pow(at, double(n)); });
    const auto basis = polynomials(x, n);
    const MinimaxFit fit = Minimax(basis, n).fit(target, kTight);
    CAPTURE(n, fit.steps);
    CHECK(fit.error == Approx(std::pow(2.0, 1.0 - double(n))).margin(kRounding));
    CHECK(fit.lower_bound == Approx(fit.error).margin(kRounding));
    CHECK(largestSize(errors(basis, fit, target)) == Approx(fit.error).margin(kRounding));
  }
}

TEST_CASE("Minimax, AbsoluteValueByParabolas") {
  constexpr double kGrid = 1e-5;  // how much less the discrete points ask for
  const auto x = chebyshevPoints(2000);
  const auto target = sample(x, [](double at) { return std::abs(at); });
  for (const std::size_t columns : {3u, 4u}) {  // a cube does not help: 1/8 + x^2
    const MinimaxFit fit = Minimax(polynomials(x, columns), columns).fit(target, kTight);
    CHECK(fit.error == Approx(0.125).margin(kGrid));
    CHECK(fit.coefficient[0] == Approx(0.125 + 0.5).margin(kGrid));
    CHECK(fit.coefficient[2] == Approx(0.5).margin(kGrid));
  }
}

TEST_CASE("Minimax, ReciprocalIsChebyshevs") {
  // The error of 1 / (a - x) by polynomials of degree n is (a - sqrt(a^2 - 1))^n / (a^2 - 1).
  constexpr double kGrid = 1e-4;  // 17 extrema between 2001 points: each is missed by up to (17 pi / 4000)^2 / 2
  const double a = 1.25;
  const auto x = chebyshevPoints(2000);
  const auto target = sample(x, [&](double at) { return 1.0 / (a - at); });
  for (const int degree : {0, 1, 2, 5, 9, 15}) {
    const auto columns = std::size_t(degree) + 1;
    const auto basis = polynomials(x, columns);
    const MinimaxFit fit = Minimax(basis, columns).fit(target, kTight);
    const double expected = std::pow(0.5, degree) / (a * a - 1.0);
    CAPTURE(degree, fit.steps);
    CHECK(fit.error == Approx(expected).epsilon(kGrid));
    CHECK(fit.error < fit.least_squares_error);
    CHECK(fit.steps < 60);

    // The error takes its size with alternating signs at rank + 1 points or more.
    int alternations = 0;
    double sign = 0.0;
    for (const double e : errors(basis, fit, target)) {
      if (std::abs(e) < (1.0 - 1e-6) * fit.error || e * sign > 0.0) continue;
      sign = e;
      ++alternations;
    }
    CHECK(alternations >= degree + 2);
  }
}

TEST_CASE("Minimax, NearDelta") {
  // A line at points 0..n-1: a peak inside costs a half; one at the end (n - 2) / (2 n - 2), as the line can bend to
  // it.
  const std::size_t n = 12;
  std::vector<double> basis;
  for (std::size_t i = 0; i < n; ++i) basis.insert(basis.end(), {1.0, double(i)});
  const Minimax minimax(basis, 2);
  for (std::size_t peak = 0; peak < n; ++peak) {
    std::vector<double> target(n, 0.0);
    target[peak] = -3.0;
    const MinimaxFit fit = minimax.fit(target, kTight);
    CAPTURE(peak);
    CHECK(fit.error == Approx(3.0 * (peak == 0 || peak == n - 1 ? 10.0 / 22.0 : 0.5)).margin(kRounding));
  }
}

TEST_CASE("Minimax, NoSetOfPointsProvesMore") {
  // By duality the least error is the largest level of any three points, for two columns: brute force.
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    const std::size_t points = 14;
    auto basis = tests::randomNumbers(2 * points, seed);
    const auto target = tests::randomNumbers(points, 1000 + seed);
    if (seed % 4 == 0)  // pairs of points that the basis cannot tell apart
      for (std::size_t i = 0; i < points; i += 2) std::copy_n(&basis[2 * i], 2, &basis[2 * i + 2]);
    double level = 0.0;
    for (std::size_t i = 0; i < points; ++i)
      for (std::size_t j = 0; j < i; ++j)
        for (std::size_t k = 0; k < j; ++k) {
          const auto cross = [&](std::size_t p, std::size_t q) {
            return basis[2 * p] * basis[2 * q + 1] - basis[2 * q] * basis[2 * p + 1];
          };
          const double size = std::abs(cross(j, k)) + std::abs(cross(k, i)) + std::abs(cross(i, j));
          if (size == 0.0) continue;
          level = std::max(
              level, std::abs(cross(j, k) * target[i] + cross(k, i) * target[j] + cross(i, j) * target[k]) / size);
        }
    const MinimaxFit fit = Minimax(basis, 2).fit(target, kTight);
    CAPTURE(seed, fit.steps);
    CHECK(fit.error == Approx(level).margin(kRounding));
    CHECK(fit.lower_bound == Approx(level).margin(kRounding));
  }
}

TEST_CASE("Minimax, Weights") {
  // A constant for 0 and 1 of weights u and v leaves u v / (u + v); a point without weight does not count.
  const std::vector<double> weight = {2.0, 3.0, 0.0};
  const std::vector<double> target = {0.0, 1.0, 50.0};
  const MinimaxFit fit = Minimax(std::vector<double>(3, 1.0), 1, weight).fit(target, kTight);
  CHECK(fit.error == Approx(6.0 / 5.0).margin(kRounding));
  CHECK(fit.coefficient[0] == Approx(3.0 / 5.0).margin(kRounding));
  CHECK(fit.least_squares_error == Approx(2.0 * 9.0 / 13.0).margin(kRounding));
}

TEST_CASE("Minimax, DependentColumns") {
  const auto x = chebyshevPoints(100);
  const auto target = sample(x, [](double at) { return std::exp(at) + (at > 0.3 ? 0.2 : 0.0); });
  const MinimaxFit plain = Minimax(polynomials(x, 3), 3).fit(target, kTight);
  std::vector<double> basis;  // 1, x, 0, x^2, 1 - 2 x, x^2 in other units
  for (const double at : x) basis.insert(basis.end(), {1.0, at, 0.0, at * at, 1.0 - 2.0 * at, 1e-30 * at * at});
  const MinimaxFit fit = Minimax(basis, 6).fit(target, kTight);
  CHECK(fit.error == Approx(plain.error).margin(kRounding));
  CHECK(fit.lower_bound == Approx(plain.error).margin(kRounding));
  CHECK(largestSize(errors(basis, fit, target)) == Approx(fit.error).margin(kRounding));
  CHECK(std::count(fit.coefficient.begin(), fit.coefficient.end(), 0.0) == 3);

  const MinimaxFit none = Minimax(std::vector<double>(20, 0.0), 2).fit(tests::randomNumbers(10, 4));
  CHECK(none.error == largestSize(tests::randomNumbers(10, 4)));
  CHECK(none.lower_bound == none.error);
}

TEST_CASE("Minimax, NothingToDo") {
  const auto x = chebyshevPoints(60);
  const Minimax minimax(polynomials(x, 5), 5);
  const MinimaxFit zero = minimax.fit(std::vector<double>(x.size(), 0.0));
  CHECK(zero.error == 0.0);
  CHECK(zero.coefficient == std::vector<double>(5, 0.0));
  const MinimaxFit exact = minimax.fit(sample(x, [](double at) { return 1.0 - 3.0 * at + at * at * at; }));
  CHECK(exact.error <= kRounding);
  CHECK(exact.steps == 0);
  const MinimaxFit interpolated =
      Minimax({std::vector<double>{1.0, 0.0, 1.0, 1.0}}, 2).fit(std::vector<double>{2.0, 5.0});
  CHECK(interpolated.error <= kRounding);
  CHECK(Minimax({}, 2).fit({}).error == 0.0);
}

TEST_CASE("Minimax, EveryStepIsWithinItsBounds") {
  const auto x = chebyshevPoints(300);
  const auto target = sample(x, [](double at) { return 1.0 / (1.0 + 90.0 * (at - 0.4) * (at - 0.4)); });
  const Minimax minimax(polynomials(x, 11), 11);
  const double least = minimax.fit(target, kTight).error;
  double bound = 0.0;
  for (std::size_t steps = 0; steps < 40; ++steps) {
    const MinimaxFit fit = minimax.fit(target, {0.0, steps});
    CAPTURE(steps);
    CHECK(fit.steps <= steps);
    CHECK(fit.error <= fit.least_squares_error);
    CHECK(fit.error >= least - kRounding);
    CHECK(fit.lower_bound <= least + kRounding);
    CHECK(fit.lower_bound >= bound - kRounding);
    bound = fit.lower_bound;
  }
  CHECK(bound == Approx(least).margin(kRounding));
}

TEST_CASE("Minimax, LobesOnTheSphere") {
  // A clamped cosine and a lobe too narrow for 16 coefficients, on normals whose mirror images fall together in half of
  // them: within the limit that was asked for, well before the steps run out.
  const LatitudeRecurrence recurrence(4);
  std::vector<double> basis;
  std::vector<double> wide;
  std::vector<double> narrow;
  const det::Number3 sun(0.6, 0.0, 0.8);
  for (det::Number3 normal : normals()) {
    if (normal.x < 0.0) normal.x = -normal.x;
    std::vector<double> value(16);
    evaluateBasis(recurrence, normal, value);
    basis.insert(basis.end(), value.begin(), value.end());
    const double cosine = dot(normal, sun);
    wide.push_back(std::max(cosine, 0.0));
    narrow.push_back(1.0 / (1.0 + 200.0 * (1.0 - cosine)));
  }
  const Minimax minimax(basis, 16);
  for (const auto& target : {wide, narrow}) {
    const MinimaxFit fit = minimax.fit(target);
    CAPTURE(fit.steps, fit.error, fit.least_squares_error);
    CHECK(fit.error <= 1.01 * fit.lower_bound);
    CHECK(fit.error < 0.9 * fit.least_squares_error);
    CHECK(fit.steps < 100);
  }
}

TEST_CASE("Minimax, PointsThatFallTogether") {
  // Bases of whole numbers, or of 0 and 1, have many points on which references degenerate.
  for (std::uint32_t seed = 0; seed < 400; ++seed) {
    const std::size_t columns = 1 + seed % 16;
    const std::size_t points = columns + 1 + 7 * (seed % 17);
    auto basis = tests::randomNumbers(columns * points, 2 * seed);
    auto target = tests::randomNumbers(points, 2 * seed + 1);
    if (seed % 2 == 0) {
      for (double& entry : basis) entry = std::round(2.0 * entry);
      for (double& entry : target) entry = std::round(2.0 * entry);
    } else {
      for (double& entry : basis) entry = entry > 0.0 ? 1.0 : 0.0;
      std::fill(target.begin(), target.end(), 0.0);
      target[seed % points] = 1.0;
    }
    const MinimaxFit fit = Minimax(basis, columns).fit(target);
    CAPTURE(seed, columns, points, fit.steps, fit.error, fit.lower_bound);
    CHECK(fit.error <= fit.least_squares_error);
    CHECK(fit.error <= 1.01 * fit.lower_bound + kRounding);
    CHECK(fit.steps < 100);
  }
}

TEST_CASE("Minimax, AnySizeOfNumbers") {
  const auto x = chebyshevPoints(100);
  const auto target = sample(x, [](double at) { return 1.0 / (1.25 - at); });
  const double expected = Minimax(polynomials(x, 4), 4).fit(target, kTight).error;
  for (const double basis_scale : {1e-100, 1e100})
    for (const double target_scale : {1e-100, 1e100}) {
      auto basis = polynomials(x, 4);
      for (double& entry : basis) entry *= basis_scale;
      auto scaled = target;
      for (double& entry : scaled) entry *= target_scale;
      CHECK(Minimax(basis, 4).fit(scaled, kTight).error == Approx(expected * target_scale));
    }
}

TEST_CASE("Minimax, SameBits") {
  const std::size_t points = 500;
  const auto basis = tests::randomNumbers(points * 9, 1);
  const auto weight = tests::randomNumbers(points, 2);
  std::vector<double> positive;
  for (const double w : weight) positive.push_back(1.5 + w);
  const MinimaxFit fit = Minimax(basis, 9, positive).fit(tests::randomNumbers(points, 3));
  CHECK(fit.steps == 12);  // 18 when points come in with the wrong sign, which mends itself
  CHECK(tests::checksum(fit.coefficient) == 0x1a11abfa04e6f4e4u);
}

}  // namespace
}  // namespace welkin::sh
