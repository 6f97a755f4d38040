// SPDX-License-Identifier: Apache-2.0
// Eigenvectors against closed forms and against what defines them.
#include "sh/symmetric_eigen.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/sh/bits.h"

namespace welkin::sh {
namespace {

constexpr double kRounding = 2e-14;  // of the largest eigenvalue: some 10 n units in the last place of 1 for n of 10

double dotProduct(const double* a, const double* b, std::size_t n) {
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i) sum += a[i] * b[i];
  return sum;
}

void checkEigensystem(const std::vector<double>& matrix, std::size_t n, std::size_t count, double tolerance) {
  const Eigensystem eigen = leadingEigenvectors(matrix, n, count);
  REQUIRE(eigen.value.size() == std::min(n, count));
  REQUIRE(eigen.vector.size() == eigen.value.size() * n);
  double scale = 0.0;
  for (const double entry : matrix) scale = std::max(scale, std::abs(entry));
  double worst = 0.0;
  for (std::size_t k = 0; k < eigen.value.size(); ++k) {
    const double* v = &eigen.vector[k * n];
    for (std::size_t i = 0; i < n; ++i)
      worst = std::max(worst, std::abs(dotProduct(&matrix[i * n], v, n) - eigen.value[k] * v[i]) / scale);
    for (std::size_t j = 0; j <= k; ++j)
      worst = std::max(worst, std::abs(dotProduct(v, &eigen.vector[j * n], n) - (j == k ? 1.0 : 0.0)));
    if (k > 0) CHECK(eigen.value[k] <= eigen.value[k - 1]);
  }
  CAPTURE(n, scale);
  CHECK(worst <= tolerance);
}

std::vector<double> randomSymmetric(std::size_t n, std::uint32_t seed) {
  std::vector<double> matrix = tests::randomNumbers(n * n, seed);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j) matrix[i * n + j] = matrix[j * n + i];
  return matrix;
}

TEST_CASE("LeadingEigenvectors, SecondDifferences") {
  const std::size_t n = 50;
  std::vector<double> matrix(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    matrix[i * n + i] = 2.0;
    if (i + 1 < n) matrix[i * n + i + 1] = matrix[(i + 1) * n + i] = -1.0;
  }
  const Eigensystem eigen = leadingEigenvectors(matrix, n, n);
  for (std::size_t k = 0; k < n; ++k)
    CHECK(eigen.value[k] == Approx(2.0 + 2.0 * std::cos(M_PI * double(k + 1) / double(n + 1))).margin(5.0 * kRounding));
  checkEigensystem(matrix, n, n, 5.0 * kRounding);
}

TEST_CASE("LeadingEigenvectors, TwoByTwo") {
  const Eigensystem eigen = leadingEigenvectors({1.0, 2.0, 2.0, -2.0}, 2, 2);  // 2 along (2, 1), -3 along (1, -2)
  CHECK(eigen.value[0] == Approx(2.0).margin(kRounding));
  CHECK(eigen.value[1] == Approx(-3.0).margin(kRounding));
  CHECK(eigen.vector[0] / eigen.vector[1] == Approx(2.0).margin(kRounding));
  CHECK(eigen.vector[2] / eigen.vector[3] == Approx(-0.5).margin(kRounding));
}

TEST_CASE("LeadingEigenvectors, AnyMatrix") {
  for (const std::size_t n : {1u, 2u, 3u, 7u, 40u, 130u})
    checkEigensystem(randomSymmetric(n, std::uint32_t(n)), n, n, double(n + 10) / 10.0 * kRounding);
}

TEST_CASE("LeadingEigenvectors, RepeatedAndMissingOnes") {
  const std::size_t n = 12;
  std::vector<double> matrix(n * n, 0.0);
  checkEigensystem(std::vector<double>(n * n, 1.0), n, n, kRounding);  // n once, 0 n - 1 times
  for (std::size_t i = 0; i < n; ++i) matrix[i * n + i] = 1.0;
  checkEigensystem(matrix, n, n, kRounding);
  for (const double zero : leadingEigenvectors(std::vector<double>(n * n, 0.0), n, n).value) CHECK(zero == 0.0);
  CHECK(leadingEigenvectors({}, 0, 3).value.empty());
}

TEST_CASE("LeadingEigenvectors, AnySizeOfNumbers") {
  for (const double scale : {1e-300, 1e-160, 1e160, 1e300}) {
    std::vector<double> matrix = randomSymmetric(9, 5);
    for (double& entry : matrix) entry *= scale;
    checkEigensystem(matrix, 9, 4, kRounding);
  }
  std::vector<double> graded = randomSymmetric(20, 6);  // from 1 down to 1e-304
  for (std::size_t i = 0; i < 20; ++i)
    for (std::size_t j = 0; j < 20; ++j) graded[i * 20 + j] *= std::pow(1e-8, double(i + j));
  checkEigensystem(graded, 20, 20, kRounding);
}

}  // namespace
}  // namespace welkin::sh
