// SPDX-License-Identifier: Apache-2.0
// Bounded least squares beside Eigen's dense solution and beside the conditions of a bounded minimum.
#include "probes/fit/least_squares.h"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>

#include "probes/geometry/random.h"

namespace welkin::tests {
namespace {

constexpr std::size_t kUnknowns = 12, kRows = 90, kColumns = 2;
constexpr double kPull = 0.1;
/// Of the error that kSweeps leave of these well-conditioned rows, relative to numbers about 1.
constexpr double kLeft = 1e-9;

std::vector<fit::Row> someRows() {
  geometry::Random random(31);
  std::vector<fit::Row> rows(kRows);
  for (fit::Row& row : rows) {
    row.weight = 0.2 + random.unit();
    for (std::uint32_t u = 0; u < kUnknowns; ++u)
      if (random.unit() < 0.3) row.entry.push_back({u, random.unit() - 0.3});
  }
  return rows;
}

struct Problem {
  std::vector<fit::Row> row = someRows();
  std::vector<double> wanted, start, moment;

  Problem() : moment(kUnknowns * kColumns, 0.0) {
    geometry::Random random(32);
    for (std::size_t i = 0; i < kRows * kColumns; ++i) wanted.push_back(random.unit() - 0.4);
    for (std::size_t i = 0; i < kUnknowns * kColumns; ++i) start.push_back(random.unit());
    for (std::size_t r = 0; r < kRows; ++r)
      for (const auto& e : row[r].entry)
        for (std::size_t c = 0; c < kColumns; ++c)
          moment[e.unknown * kColumns + c] += row[r].weight * e.factor * wanted[r * kColumns + c];
  }

  Eigen::MatrixXd normal(double pull) const {
    Eigen::MatrixXd n = Eigen::MatrixXd::Zero(kUnknowns, kUnknowns);
    for (const fit::Row& r : row)
      for (const auto& a : r.entry)
        for (const auto& b : r.entry) n(a.unknown, b.unknown) += r.weight * a.factor * b.factor;
    n.diagonal().array() += pull;
    return n;
  }
};

}  // namespace

TEST_CASE("LeastSquares, WithoutBoundsItIsTheDenseSolution") {
  const Problem p;
  const fit::NormalMatrix matrix(kUnknowns, p.row, kPull);
  CHECK(matrix.pull() == Approx(kPull * p.normal(0.0).diagonal().mean()));
  std::vector<double> x = p.start;
  fit::solveBounded(matrix, kColumns, p.moment, x, [](std::size_t, std::span<double>) {});
  for (std::size_t c = 0; c < kColumns; ++c) {
    Eigen::VectorXd right(kUnknowns);
    for (std::size_t u = 0; u < kUnknowns; ++u)
      right(static_cast<Eigen::Index>(u)) = p.moment[u * kColumns + c] + matrix.pull() * p.start[u * kColumns + c];
    const Eigen::VectorXd want = p.normal(matrix.pull()).ldlt().solve(right);
    for (std::size_t u = 0; u < kUnknowns; ++u)
      CHECK(x[u * kColumns + c] == Approx(want(static_cast<Eigen::Index>(u))).margin(kLeft));
  }
}

TEST_CASE("LeastSquares, AtABoundTheGradientPointsOutwards") {
  const Problem p;
  const fit::NormalMatrix matrix(kUnknowns, p.row, kPull);
  std::vector<double> x = p.start;
  fit::solveBounded(matrix, kColumns, p.moment, x, [](std::size_t, std::span<double> numbers) {
    for (double& v : numbers) v = std::max(v, 0.0);
  });
  std::size_t bounded = 0;
  const Eigen::MatrixXd n = p.normal(matrix.pull());
  for (std::size_t c = 0; c < kColumns; ++c)
    for (std::size_t u = 0; u < kUnknowns; ++u) {
      double gradient = -p.moment[u * kColumns + c] - matrix.pull() * p.start[u * kColumns + c];
      for (std::size_t v = 0; v < kUnknowns; ++v)
        gradient += n(static_cast<Eigen::Index>(u), static_cast<Eigen::Index>(v)) * x[v * kColumns + c];
      if (x[u * kColumns + c] > 0.0) {
        CHECK(std::abs(gradient) < kLeft * n(static_cast<Eigen::Index>(u), static_cast<Eigen::Index>(u)));
      } else {
        CHECK(gradient >= 0.0);
        ++bounded;
      }
    }
  CHECK(bounded > 0);
  CHECK(bounded < kUnknowns * kColumns);
}

TEST_CASE("LeastSquares, AnUnknownWithoutRowsStays") {
  const std::vector<fit::Row> rows = {{{{0, 1.0}}, 1.0}};
  const fit::NormalMatrix matrix(2, rows, kPull);
  std::vector<double> x = {0.0, 0.7};
  const std::vector<double> moment = {1.0, 0.0};
  fit::solveBounded(matrix, 1, moment, x, [](std::size_t, std::span<double>) {});
  CHECK(x[0] == Approx(1.0 / 1.1));
  CHECK(x[1] == Approx(0.7));
}

}  // namespace welkin::tests
