// SPDX-License-Identifier: Apache-2.0
#include "sh/basis.h"

#include <cmath>

namespace welkin::sh {

LatitudeRecurrence::LatitudeRecurrence(int bands)
    : diagonal_(static_cast<std::size_t>(bands)), step_(static_cast<std::size_t>(coefficientCount(bands))) {
  // Orthonormal over the sphere; sqrt(2) joins the orders m > 0 because cos and sin share the power.
  double diagonal = std::sqrt(1.0 / (4.0 * det::kPi));
  for (int m = 0; m < bands; ++m) {
    if (m > 0) diagonal *= std::sqrt((m == 1 ? 2.0 : 1.0) * (2.0 * m + 1.0) / (2.0 * m));
    diagonal_[static_cast<std::size_t>(m)] = diagonal;
    for (int l = m + 1; l < bands; ++l) {
      const double ll = double(l) * l;
      const double mm = double(m) * m;
      Step& step = step_[static_cast<std::size_t>(indexOf(l, m))];
      step.climb = std::sqrt((4.0 * ll - 1.0) / (ll - mm));
      if (l - 1 > m)
        step.fall = std::sqrt((2.0 * l + 1.0) * ((l - 1.0) * (l - 1.0) - mm) / ((2.0 * l - 3.0) * (ll - mm)));
    }
  }
}

void LatitudeRecurrence::evaluate(double s, double c, std::span<double> out) const {
  double power = 1.0;
  for (int m = 0; m < bands(); ++m) {
    double before = 0.0;
    double current = diagonal(m) * power;
    power *= c;
    out[static_cast<std::size_t>(indexOf(m, m))] = current;
    for (int l = m + 1; l < bands(); ++l) {
      const double next = climb(l, m) * s * current - fall(l, m) * before;
      before = current;
      current = next;
      out[static_cast<std::size_t>(indexOf(l, m))] = current;
    }
  }
}

void evaluateBasis(const LatitudeRecurrence& recurrence, const det::Number3& direction, std::span<double> out) {
  const int bands = recurrence.bands();
  const double c = std::sqrt(direction.x * direction.x + direction.y * direction.y);
  recurrence.evaluate(direction.z, c, out);
  const double cos_phi = c > 0.0 ? direction.x / c : 1.0;
  const double sin_phi = c > 0.0 ? direction.y / c : 0.0;
  double cos_m = 1.0;
  double sin_m = 0.0;
  for (int m = 1; m < bands; ++m) {
    const double next = cos_m * cos_phi - sin_m * sin_phi;
    sin_m = sin_m * cos_phi + cos_m * sin_phi;
    cos_m = next;
    for (int l = m; l < bands; ++l) {
      const double factor = out[static_cast<std::size_t>(indexOf(l, m))];
      out[static_cast<std::size_t>(indexOf(l, m))] = factor * cos_m;
      out[static_cast<std::size_t>(indexOf(l, -m))] = factor * sin_m;
    }
  }
}

}  // namespace welkin::sh
