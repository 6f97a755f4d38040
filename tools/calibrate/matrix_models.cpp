// SPDX-License-Identifier: Apache-2.0
#include "calibrate/matrix_models.h"

#include <algorithm>
#include <cmath>

#include "calibrate/least_squares.h"

namespace welkin::calibrate {
namespace {

TermVector plainTerms(const Colour& c) {
  return c;
}

using Terms = TermVector (*)(const Colour&);

std::optional<std::vector<double>> fitTerms(std::span<const Pair> pairs, Terms terms) {
  const auto count = static_cast<Eigen::Index>(pairs.size());
  if (count == 0) return std::nullopt;
  const Eigen::Index unknowns = terms(pairs[0].measured).size();
  Eigen::MatrixXd rows(count, unknowns), wanted(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    rows.row(i) = terms(pairs[static_cast<std::size_t>(i)].measured).transpose();
    wanted.row(i) = pairs[static_cast<std::size_t>(i)].wanted.transpose();
  }
  const auto x = leastSquares(rows, wanted, Eigen::VectorXd::Ones(count));
  if (!x) return std::nullopt;
  std::vector<double> numbers;
  for (Eigen::Index channel = 0; channel < 3; ++channel)
    for (Eigen::Index term = 0; term < unknowns; ++term) numbers.push_back((*x)(term, channel));
  return numbers;
}

Colour applyTerms(std::span<const double> numbers, const TermVector& terms) {
  using Rows = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const Rows>(numbers.data(), 3, terms.size()) * terms;
}

}  // namespace

TermVector rootTerms(const Colour& c) {
  const Colour p = c.cwiseMax(0.0);
  TermVector terms(6);
  terms << c, std::sqrt(p.x() * p.y()), std::sqrt(p.y() * p.z()), std::sqrt(p.x() * p.z());
  return terms;
}

std::optional<std::vector<double>> fitMatrix(std::span<const Pair> pairs) {
  return fitTerms(pairs, plainTerms);
}

Colour applyMatrix(std::span<const double> numbers, const Colour& measured) {
  return applyTerms(numbers, plainTerms(measured));
}

std::optional<std::vector<double>> fitRootPolynomial(std::span<const Pair> pairs) {
  return fitTerms(pairs, rootTerms);
}

Colour applyRootPolynomial(std::span<const double> numbers, const Colour& measured) {
  return applyTerms(numbers, rootTerms(measured));
}

}  // namespace welkin::calibrate
