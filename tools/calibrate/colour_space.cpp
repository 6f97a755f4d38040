// SPDX-License-Identifier: Apache-2.0
#include "calibrate/colour_space.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "sh/deterministic.h"
#include "sky/image/colour.h"

namespace welkin::calibrate {
namespace {

using Matrix = Eigen::Matrix3d;

/// The white of ICC profiles and of charts, CIE 15:2004, table T.3.
constexpr std::array<double, 2> kD50 = {0.34567, 0.35850};

Matrix matrixOf(const image::ColourMatrix& m) {
  Matrix result;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) result(row, column) = m.column[static_cast<std::size_t>(column)][row];
  return result;
}

const Matrix& toXyz() {
  static const Matrix kMatrix = matrixOf(*image::toXyz(image::kRec709));
  return kMatrix;
}

const Matrix& fromXyz() {
  static const Matrix kMatrix = toXyz().inverse();
  return kMatrix;
}

const Matrix& fromXyzD50() {
  static const Matrix kMatrix = matrixOf(image::rec709OfXyz(kD50));
  return kMatrix;
}

const Matrix& toXyzD50() {
  static const Matrix kMatrix = fromXyzD50().inverse();
  return kMatrix;
}

/// XYZ of the white of luminance 1.
Colour whiteD50() {
  return xyzOfXyY({kD50[0], kD50[1], 1.0});
}

constexpr double kEdge = 6.0 / 29.0;

double labCurve(double t) {
  return t > kEdge * kEdge * kEdge ? std::cbrt(t) : t / (3.0 * kEdge * kEdge) + 4.0 / 29.0;
}

double labCurveInverse(double f) {
  return f > kEdge ? f * f * f : 3.0 * kEdge * kEdge * (f - 4.0 / 29.0);
}

}  // namespace

Colour xyzOfRgb(const Colour& rgb) {
  return toXyz() * rgb;
}

Colour rgbOfXyz(const Colour& xyz) {
  return fromXyz() * xyz;
}

Colour xyYOfXyz(const Colour& xyz) {
  const double sum = xyz.sum();
  if (!(sum > 0.0)) return {image::kRec709.white[0], image::kRec709.white[1], xyz.y()};
  return {xyz.x() / sum, xyz.y() / sum, xyz.y()};
}

Colour xyzOfXyY(const Colour& xyY) {
  const double scale = xyY.z() / xyY.y();
  return {xyY.x() * scale, xyY.z(), (1.0 - xyY.x() - xyY.y()) * scale};
}

Colour labOfRgb(const Colour& rgb) {
  const Colour f = (toXyzD50() * rgb).cwiseQuotient(whiteD50()).unaryExpr(&labCurve);
  return {116.0 * f.y() - 16.0, 500.0 * (f.x() - f.y()), 200.0 * (f.y() - f.z())};
}

Colour rgbOfLab(const Colour& lab) {
  const double y = (lab.x() + 16.0) / 116.0;
  const Colour f(y + lab.y() / 500.0, y, y - lab.z() / 200.0);
  return fromXyzD50() * f.unaryExpr(&labCurveInverse).cwiseProduct(whiteD50());
}

Colour rgbOfXyYD50(const Colour& xyY) {
  return fromXyzD50() * xyzOfXyY(xyY);
}

Colour srgbOfRgb(const Colour& rgb) {
  return rgb.unaryExpr([](double v) { return det::srgbEncode(std::clamp(v, 0.0, 1.0)); });
}

}  // namespace welkin::calibrate
