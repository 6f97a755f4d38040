// SPDX-License-Identifier: Apache-2.0
#include "calibrate/affine_cubic.h"

#include <algorithm>
#include <cmath>

#include "calibrate/least_squares.h"

namespace welkin::calibrate {
namespace {

/// Least chromaticity y: below it X = x Y / y explodes. Rec. 709's blue has 0.06.
constexpr double kLeastY = 0.02;

/// x |-> c0 + c1 x + c2 x^2 + c3 x^3 from `low` to `high`, and along the tangents outside.
struct Curve {
  double low, high;
  std::array<double, 4> c;

  double slope(double x) const { return c[1] + x * (2.0 * c[2] + 3.0 * x * c[3]); }
  double operator()(double x) const {
    const double in = std::clamp(x, low, high);
    return c[0] + in * (c[1] + in * (c[2] + in * c[3])) + slope(in) * (x - in);
  }
  /// Whether it rises all over the range. The slope is a parabola, so its ends and its vertex tell.
  bool rises() const {
    const double vertex = c[3] != 0.0 ? std::clamp(-c[2] / (3.0 * c[3]), low, high) : low;
    return slope(low) > 0.0 && slope(high) > 0.0 && slope(vertex) > 0.0;
  }
};

using Affine = Eigen::Matrix<double, 3, 4>;

/// The stages, as the model's numbers hold them.
struct Stages {
  Colour gain = Colour::Ones();
  Affine first = Affine::Identity();
  std::array<Curve, 3> curve;
  Affine last = Affine::Identity();
};

Colour mapped(const Affine& affine, const Colour& c) {
  return affine.leftCols<3>() * c + affine.col(3);
}

Colour curved(const std::array<Curve, 3>& curve, const Colour& c) {
  return {curve[0](c[0]), curve[1](c[1]), curve[2](c[2])};
}

std::vector<double> numbersOf(const Stages& s) {
  std::vector<double> n(s.gain.begin(), s.gain.end());
  const auto put = [&n](const Affine& a) {
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column) n.push_back(a(row, column));
  };
  put(s.first);
  for (const Curve& curve : s.curve) {
    n.insert(n.end(), {curve.low, curve.high});
    n.insert(n.end(), curve.c.begin(), curve.c.end());
  }
  put(s.last);
  return n;
}

Stages stagesOf(std::span<const double> n) {
  Stages s;
  std::size_t at = 0;
  for (double& g : s.gain) g = n[at++];
  const auto take = [&](Affine& a) {
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column) a(row, column) = n[at++];
  };
  take(s.first);
  for (Curve& curve : s.curve) {
    curve.low = n[at++];
    curve.high = n[at++];
    for (double& c : curve.c) c = n[at++];
  }
  take(s.last);
  return s;
}

using Column = std::vector<double>;
using Points = std::vector<Colour>;

Affine fittedAffine(const Points& from, const Points& to) {
  const auto count = static_cast<Eigen::Index>(from.size());
  Eigen::MatrixXd rows(count, 4), wanted(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    rows.row(i) << from[static_cast<std::size_t>(i)].transpose(), 1.0;
    wanted.row(i) = to[static_cast<std::size_t>(i)].transpose();
  }
  const auto x = leastSquares(rows, wanted, Eigen::VectorXd::Ones(count));
  return x ? Affine(x->transpose()) : Affine(Affine::Identity());
}

/// The cubic of least squares that rises; else the parabola or the line that does, else x itself.
Curve fittedCurve(const Points& from, const Points& to, int channel) {
  const auto count = static_cast<Eigen::Index>(from.size());
  Curve curve{from[0][channel], from[0][channel], {0.0, 1.0, 0.0, 0.0}};
  for (const Colour& c : from) {
    curve.low = std::min(curve.low, c[channel]);
    curve.high = std::max(curve.high, c[channel]);
  }
  for (int degree = 3; degree >= 1; --degree) {
    Eigen::MatrixXd rows(count, degree + 1), wanted(count, 1);
    for (Eigen::Index i = 0; i < count; ++i) {
      const double x = from[static_cast<std::size_t>(i)][channel];
      for (int d = 0; d <= degree; ++d) rows(i, d) = d == 0 ? 1.0 : rows(i, d - 1) * x;
      wanted(i, 0) = to[static_cast<std::size_t>(i)][channel];
    }
    const auto solution = leastSquares(rows, wanted, Eigen::VectorXd::Ones(count));
    if (!solution) continue;
    Curve found{curve.low, curve.high, {}};
    for (int d = 0; d <= degree; ++d) found.c[static_cast<std::size_t>(d)] = (*solution)(d, 0);
    if (found.rises()) return found;
  }
  return curve;
}

Colour gained(const Colour& gain, const Colour& c) {
  return gain.cwiseProduct(c);
}

/// The nearest x, y and Y that are a colour's, or nearly.
Colour physical(const Colour& xyY) {
  const double y = std::clamp(xyY.y(), kLeastY, 1.0);
  return {std::clamp(xyY.x(), 0.0, 1.0 - y), y, std::max(xyY.z(), 0.0)};
}

}  // namespace

std::optional<std::vector<double>> fitAffineCubic(std::span<const Pair> pairs) {
  Stages s;
  Colour squares = Colour::Zero(), products = Colour::Zero();
  for (const Pair& p : pairs) {
    squares += p.measured.cwiseAbs2();
    products += p.measured.cwiseProduct(p.wanted);
  }
  s.gain = products.cwiseQuotient(squares);
  if (!s.gain.allFinite() || !(s.gain.minCoeff() > 0.0)) return std::nullopt;

  Points from, to;
  Eigen::MatrixXd chromaticities(static_cast<Eigen::Index>(pairs.size()), 3);
  for (const Pair& p : pairs) {
    from.push_back(xyYOfXyz(xyzOfRgb(gained(s.gain, p.measured))));
    to.push_back(xyYOfXyz(xyzOfRgb(p.wanted)));
    chromaticities.row(static_cast<Eigen::Index>(from.size()) - 1) << from.back().x(), from.back().y(), 1.0;
  }
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(chromaticities.rows());
  if (!leastSquares(chromaticities, ones, ones)) return std::nullopt;

  s.first = fittedAffine(from, to);
  for (Colour& c : from) c = mapped(s.first, c);
  for (int channel = 0; channel < 3; ++channel)
    s.curve[static_cast<std::size_t>(channel)] = fittedCurve(from, to, channel);
  for (Colour& c : from) c = curved(s.curve, c);
  s.last = fittedAffine(from, to);
  return numbersOf(s);
}

Colour applyAffineCubic(std::span<const double> numbers, const Colour& measured) {
  const Stages s = stagesOf(numbers);
  const Colour from = xyYOfXyz(xyzOfRgb(gained(s.gain, measured)));
  return rgbOfXyz(xyzOfXyY(physical(mapped(s.last, curved(s.curve, mapped(s.first, from))))));
}

double squaresInXyY(std::span<const Pair> pairs, const Model& model) {
  double sum = 0.0;
  for (const Pair& p : pairs)
    sum += (xyYOfXyz(xyzOfRgb(model(p.measured))) - xyYOfXyz(xyzOfRgb(p.wanted))).squaredNorm();
  return sum;
}

}  // namespace welkin::calibrate
