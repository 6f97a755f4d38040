// SPDX-License-Identifier: Apache-2.0
#include "calibrate/colour_difference.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

namespace welkin::calibrate {
namespace {

constexpr double kTurn = 360.0;

double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

/// Degrees in [0, 360); 0 for a grey.
double hue(double a, double b) {
  if (a == 0.0 && b == 0.0) return 0.0;
  const double degrees = std::atan2(b, a) * 180.0 / std::numbers::pi;
  return degrees < 0.0 ? degrees + kTurn : degrees;
}

/// c^7 / (c^7 + 25^7)
double seventh(double c) {
  const double p = std::pow(c, 7.0);
  return p / (p + 6103515625.0);
}

}  // namespace

double ciede2000(const Colour& lab, const Colour& other) {
  const double mean_c = 0.5 * (std::hypot(lab.y(), lab.z()) + std::hypot(other.y(), other.z()));
  const double g = 1.0 + 0.5 * (1.0 - std::sqrt(seventh(mean_c)));
  const double a1 = g * lab.y(), a2 = g * other.y();
  const double c1 = std::hypot(a1, lab.z()), c2 = std::hypot(a2, other.z());
  const double h1 = hue(a1, lab.z()), h2 = hue(a2, other.z());

  const bool grey = c1 * c2 == 0.0;
  double turn = grey ? 0.0 : h2 - h1;
  if (turn > 180.0) turn -= kTurn;
  if (turn < -180.0) turn += kTurn;
  const double dl = other.x() - lab.x(), dc = c2 - c1;
  const double dh = 2.0 * std::sqrt(c1 * c2) * std::sin(radians(0.5 * turn));

  double mean_h = h1 + h2;
  if (!grey) {
    if (std::abs(h1 - h2) > 180.0) mean_h += mean_h < kTurn ? kTurn : -kTurn;
    mean_h *= 0.5;
  }
  const double l = 0.5 * (lab.x() + other.x()), c = 0.5 * (c1 + c2);
  const double t = 1.0 - 0.17 * std::cos(radians(mean_h - 30.0)) + 0.24 * std::cos(radians(2.0 * mean_h)) +
                   0.32 * std::cos(radians(3.0 * mean_h + 6.0)) - 0.20 * std::cos(radians(4.0 * mean_h - 63.0));
  const double from_275 = (mean_h - 275.0) / 25.0;
  const double rotation = -2.0 * std::sqrt(seventh(c)) * std::sin(radians(60.0 * std::exp(-from_275 * from_275)));
  const double from_50 = (l - 50.0) * (l - 50.0);
  const double sl = 1.0 + 0.015 * from_50 / std::sqrt(20.0 + from_50);
  const double sc = 1.0 + 0.045 * c, sh = 1.0 + 0.015 * c * t;
  const double x = dl / sl, y = dc / sc, z = dh / sh;
  return std::sqrt(std::max(0.0, x * x + y * y + z * z + rotation * y * z));
}

DifferenceSummary summaryOf(std::vector<double> differences) {
  assert(!differences.empty());
  std::sort(differences.begin(), differences.end());
  const auto count = static_cast<double>(differences.size());
  const auto rank = static_cast<std::size_t>(std::ceil(0.95 * count));
  return {std::accumulate(differences.begin(), differences.end(), 0.0) / count, differences[rank - 1],
          differences.back()};
}

}  // namespace welkin::calibrate
