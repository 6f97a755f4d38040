// SPDX-License-Identifier: Apache-2.0
#include "sky/model/luminance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace welkin::model {

using det::Number3;

const std::vector<NamedLuminance>& namedLuminances() {
  static const std::vector<NamedLuminance> kNamed = {
      {"cie-1", {4.0, -0.70, 0.0, -1.0, 0.0, 0.0}},        {"cie-2", {4.0, -0.70, 2.0, -1.5, 0.15, 0.0}},
      {"cie-3", {1.1, -0.80, 0.0, -1.0, 0.0, 0.0}},        {"cie-4", {1.1, -0.80, 2.0, -1.5, 0.15, 0.0}},
      {"cie-5", {0.0, -1.00, 0.0, -1.0, 0.0, 0.0}},        {"cie-6", {0.0, -1.00, 2.0, -1.5, 0.15, 0.0}},
      {"cie-7", {0.0, -1.00, 5.0, -2.5, 0.30, 0.0}},       {"cie-8", {0.0, -1.00, 10.0, -3.0, 0.45, 0.0}},
      {"cie-9", {-1.0, -0.55, 2.0, -1.5, 0.15, 0.0}},      {"cie-10", {-1.0, -0.55, 5.0, -2.5, 0.30, 0.0}},
      {"cie-11", {-1.0, -0.55, 10.0, -3.0, 0.45, 0.0}},    {"cie-12", {-1.0, -0.32, 10.0, -3.0, 0.45, 0.0}},
      {"cie-13", {-1.0, -0.32, 16.0, -3.0, 0.30, 0.0}},    {"cie-14", {-1.0, -0.15, 16.0, -3.0, 0.30, 0.0}},
      {"cie-15", {-1.0, -0.15, 24.0, -2.8, 0.15, 0.0}},    {"cie-overcast", {0.0, -1.00, 0.0, -1.0, 0.0, 2.0}},
      {"far-cry-3", {-1.0, -0.08, 24.0, -3.0, 0.30, 0.0}},
  };
  return kNamed;
}

const LuminanceModel* findLuminance(std::string_view name) {
  const auto& named = namedLuminances();
  const auto it = std::find_if(named.begin(), named.end(), [&](const auto& n) { return n.name == name; });
  return it == named.end() ? nullptr : &it->model;
}

namespace {

/// Least value of a luminance factor. With coefficients up to 1e4 a relative luminance is then at most 2e26, which a
/// float holds and the runtime accepts.
constexpr double kDarkest = 1e-9;

const char* phrase(double factor) {
  return factor < 0.0 ? "negative" : factor == 0.0 ? "zero" : "nearly zero";
}

/// Finds the angle in [low, high] where the indicatrix is least: a scan by 1/8 degree, refined by golden section around
/// its best.
double darkestAngle(const LuminanceModel& m, double low, double high) {
  const int steps = std::max(8, static_cast<int>(std::ceil((high - low) / (det::kDegree / 8.0))));
  const double step = (high - low) / steps;
  double best = low;
  for (int i = 1; i <= steps; ++i)
    if (det::indicatrix(m, low + i * step) < det::indicatrix(m, best)) best = low + i * step;
  double a = std::max(low, best - step);
  double b = std::min(high, best + step);
  constexpr double kGolden = 0.61803398874989484820;
  for (int i = 0; i < 60; ++i) {
    const double x1 = b - kGolden * (b - a);
    const double x2 = a + kGolden * (b - a);
    (det::indicatrix(m, x1) < det::indicatrix(m, x2) ? b : a) =
        det::indicatrix(m, x1) < det::indicatrix(m, x2) ? x2 : x1;
  }
  const double refined = 0.5 * (a + b);
  return det::indicatrix(m, refined) < det::indicatrix(m, best) ? refined : best;
}

/// Returns a direction of the upper hemisphere at `angle` from the sun. It lies in the sun's vertical plane, past the
/// zenith or below the sun, whichever is above the horizon.
Number3 directionAtAngle(const Number3& sun, double angle) {
  const double elevation = det::elevationOf(sun);
  const double azimuth = det::atan(sun.x, -sun.z);
  const double up = elevation + angle;  // Elevation, measured over the zenith.
  return up <= det::kPi + 1e-12 ? det::directionOf(azimuth, up) : det::directionOf(azimuth, elevation - angle);
}

}  // namespace

std::optional<std::string> whyUnusable(const LuminanceModel& m, const LightPath& sun) {
  if (!(m.b < 0.0)) return fmt::format("b = {}: must be below 0", m.b);
  if (!(m.d < 0.0)) return fmt::format("d = {}: must be below 0", m.d);
  const Number3 noon = sun.directionAt(12.0);
  if (const double zenith = det::gradation(m, 1.0); !(zenith > kDarkest))
    return fmt::format(
        "a = {}: makes the luminance {} (1 + a exp b = {:.6g}) at the zenith (0, 1, 0), for any sun, for example at "
        "elevation {:.2f} degrees; with b = {} a must be above {:.6g}",
        m.a, phrase(zenith), zenith, det::elevationOf(noon) / det::kDegree, m.b, -det::exp(-m.b));
  std::vector<double> times = sun.key_time_h;
  for (int minute = 0; minute < 1440; ++minute) times.push_back(minute / 60.0);
  // The angles to the sun that the upper hemisphere shows, and 0 for the normalisation. The range is widest under the
  // lowest sun, and complete once it is below the horizon.
  double time = times.front();
  double widest = -1.0;
  for (const double t : times) {
    const double high = det::kPi - std::max(det::elevationOf(sun.directionAt(t)), 0.0);
    if (high > widest) {
      widest = high;
      time = t;
    }
  }
  const double angle = darkestAngle(m, 0.0, widest);
  const double value = det::indicatrix(m, angle);
  if (value > kDarkest) return std::nullopt;
  const Number3 s = sun.directionAt(time);
  const char* name = m.c != 0.0 && (m.c < 0.0) == (angle < det::kHalfPi) ? "c" : "e";
  const Number3 d = directionAtAngle(s, angle);
  return fmt::format(
      "{} = {}: makes the luminance {} (indicatrix {:.6g}) at sun elevation {:.2f} degrees, {:.2f} h, in direction "
      "({:.4f}, {:.4f}, {:.4f}), {:.2f} degrees from the sun; it must be above {} wherever the day's sun looks",
      name, name[0] == 'c' ? m.c : m.e, phrase(value), value, det::elevationOf(s) / det::kDegree, time, d.x, d.y, d.z,
      angle / det::kDegree, kDarkest);
}

}  // namespace welkin::model
