// SPDX-License-Identifier: Apache-2.0
#include "calibrate/chart_place.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "calibrate/reference_chart.h"

namespace welkin::calibrate {
namespace {

double crossOf(const Point& a, const Point& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Whether all corners turn the same way by a triangle of at least a quarter of a pixel.
bool isConvex(const Corners& c) {
  int left = 0, right = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double area = 0.5 * crossOf(c[(i + 1) % 4] - c[i], c[(i + 2) % 4] - c[(i + 1) % 4]);
    left += area > 0.25 ? 1 : 0;
    right += area < -0.25 ? 1 : 0;
  }
  return left == 4 || right == 4;
}

}  // namespace

std::optional<ChartPlace> ChartPlace::of(const Corners& corners) {
  for (const Point& p : corners)
    if (!p.allFinite()) return std::nullopt;
  if (!isConvex(corners)) return std::nullopt;
  // Two equations of each corner (X, Y): X (h20 x + h21 y + 1) = h00 x + h01 y + h02, and the same of Y.
  const std::array<Point, 4> model = {Point(0.0, 0.0), Point(kChartWidth, 0.0), Point(kChartWidth, kChartHeight),
                                      Point(0.0, kChartHeight)};
  Eigen::Matrix<double, 8, 8> a = Eigen::Matrix<double, 8, 8>::Zero();
  Eigen::Matrix<double, 8, 1> b;
  for (int i = 0; i < 4; ++i) {
    const Point& m = model[static_cast<std::size_t>(i)];
    const Point& p = corners[static_cast<std::size_t>(i)];
    a.row(2 * i) << m.x(), m.y(), 1.0, 0.0, 0.0, 0.0, -p.x() * m.x(), -p.x() * m.y();
    a.row(2 * i + 1) << 0.0, 0.0, 0.0, m.x(), m.y(), 1.0, -p.y() * m.x(), -p.y() * m.y();
    b[2 * i] = p.x();
    b[2 * i + 1] = p.y();
  }
  const Eigen::Matrix<double, 8, 1> h = a.colPivHouseholderQr().solve(b);
  Eigen::Matrix3d to_pixels;
  to_pixels << h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7], 1.0;
  if (!to_pixels.allFinite()) return std::nullopt;
  return ChartPlace(corners, to_pixels);
}

Point ChartPlace::pixelOf(double x, double y) const {
  return (to_pixels_ * Eigen::Vector3d(x, y, 1.0)).hnormalized();
}

Point ChartPlace::pixelOf(std::size_t patch, double u, double v) const {
  const auto column = static_cast<double>(patch % kColumns), row = static_cast<double>(patch / kColumns);
  return pixelOf(kRim + column * kPatchStep + u * kPatchSide, kRim + row * kPatchStep + v * kPatchSide);
}

double ChartPlace::shortestSide() const {
  double shortest = (pixelOf(0, 0.0, 0.0) - pixelOf(0, 1.0, 0.0)).norm();
  for (std::size_t i = 0; i < kPatches; ++i) {
    const std::array<Point, 4> p = {pixelOf(i, 0, 0), pixelOf(i, 1, 0), pixelOf(i, 1, 1), pixelOf(i, 0, 1)};
    for (std::size_t k = 0; k < 4; ++k) shortest = std::min(shortest, (p[k] - p[(k + 1) % 4]).norm());
  }
  return shortest;
}

ChartPlace ChartPlace::turned(std::size_t quarters) const {
  Corners corners;
  for (std::size_t i = 0; i < 4; ++i) corners[i] = corners_[(i + quarters) % 4];
  return *of(corners);
}

}  // namespace welkin::calibrate
