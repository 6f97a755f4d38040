// SPDX-License-Identifier: Apache-2.0
#include "calibrate/curve_models.h"

#include <algorithm>
#include <cmath>

#include "calibrate/levenberg.h"
#include "calibrate/matrix_models.h"

namespace welkin::calibrate {
namespace {

using Numbers = std::span<const double>;

/// The curve, of a value relative to the chart's brightest.
class Bend {
 public:
  Bend(double q, double t) : power_(std::exp(q)), e_(std::exp(t)) {}

  double operator()(double v) const {
    if (v >= 1.0) return 1.0 + power_ / e_ * (v - 1.0);
    const double u = std::pow(std::max(v, 0.0), power_);
    return e_ * u / (1.0 + (e_ - 1.0) * u);
  }

 private:
  double power_, e_;
};

TermVector affineTerms(const Colour& c) {
  return c.homogeneous();
}

using Terms = TermVector (*)(const Colour&);

Colour applied(Numbers n, const Colour& measured, Terms terms) {
  const Colour curve = (measured / n[0]).unaryExpr(Bend(n[1], n[2]));
  const TermVector term = terms(curve);
  using Rows = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const Rows>(n.data() + 3, 3, term.size()) * term;
}

/// Lightness, chroma and hue differences from a wanted colour, weighted as CIE94 weights them (CIE 116:1995) by the
/// wanted chroma: squares of smooth functions of the colour, unlike those of CIEDE2000.
Colour perceivedError(const Colour& rgb, const Colour& wanted_lab) {
  const Colour a = labOfRgb(rgb);
  const Colour& b = wanted_lab;
  const double chroma = std::hypot(b.y(), b.z());
  const double da = a.y() - b.y(), db = a.z() - b.z();
  const double cosine = chroma > 0.0 ? b.y() / chroma : 1.0, sine = chroma > 0.0 ? b.z() / chroma : 0.0;
  return {a.x() - b.x(), (cosine * da + sine * db) / (1.0 + 0.045 * chroma),
          (cosine * db - sine * da) / (1.0 + 0.015 * chroma)};
}

/// Pulls the curve to a straight line, and terms beyond the matrix to 0, where the chart says little of them. A pull is
/// as strong as one patch that is off by this much for each unit.
constexpr double kPullOfCurve = 2.0, kPullOfTerms = 10.0;

std::optional<std::vector<double>> fitted(std::span<const Pair> pairs, Terms terms) {
  double brightest = 0.0;
  for (const Pair& p : pairs) brightest = std::max(brightest, p.measured.maxCoeff());
  if (!(brightest > 0.0)) return std::nullopt;
  std::vector<Pair> relative(pairs.begin(), pairs.end());
  for (Pair& p : relative) p.measured /= brightest;
  const auto matrix = fitMatrix(relative);
  std::vector<Colour> lab;
  for (const Pair& p : relative) lab.push_back(labOfRgb(p.wanted));
  if (!matrix) return std::nullopt;

  const Eigen::Index count = terms(Colour::Zero()).size();
  Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(2 + 3 * count);
  for (Eigen::Index row = 0; row < 3; ++row)
    for (Eigen::Index column = 0; column < 3; ++column)
      unknowns[2 + row * count + column] = (*matrix)[static_cast<std::size_t>(3 * row + column)];
  const auto numbersOf = [](const Eigen::VectorXd& x, double scale) {
    std::vector<double> numbers{scale};
    numbers.insert(numbers.end(), x.begin(), x.end());
    return numbers;
  };
  const auto residuals = [&](const Eigen::VectorXd& x) {
    const std::vector<double> numbers = numbersOf(x, 1.0);
    Eigen::VectorXd left(static_cast<Eigen::Index>(3 * relative.size()) + x.size() - 9);
    Eigen::Index at = 0;
    for (std::size_t i = 0; i < relative.size(); ++i, at += 3)
      left.segment<3>(at) = perceivedError(applied(numbers, relative[i].measured, terms), lab[i]);
    for (const double bend : x.head<2>()) left[at++] = kPullOfCurve * bend;
    for (Eigen::Index row = 0; row < 3; ++row)
      for (Eigen::Index column = 3; column < count; ++column) left[at++] = kPullOfTerms * x[2 + row * count + column];
    return left;
  };
  return numbersOf(leastSquaresFrom(unknowns, residuals), brightest);
}

}  // namespace

std::optional<std::vector<double>> fitCurveAffine(std::span<const Pair> pairs) {
  return fitted(pairs, affineTerms);
}

Colour applyCurveAffine(std::span<const double> numbers, const Colour& measured) {
  return applied(numbers, measured, affineTerms);
}

std::optional<std::vector<double>> fitCurveRoot(std::span<const Pair> pairs) {
  return fitted(pairs, rootTerms);
}

Colour applyCurveRoot(std::span<const double> numbers, const Colour& measured) {
  return applied(numbers, measured, rootTerms);
}

}  // namespace welkin::calibrate
