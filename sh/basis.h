// SPDX-License-Identifier: Apache-2.0
// Real spherical harmonics of any number of bands: orthonormal, no Condon-Shortley phase, index l (l + 1) + m.
// The closed forms of shaders/shared/sh.glsl are the first five bands of the same functions.
#pragma once

#include <span>
#include <vector>

#include "sh/deterministic.h"

namespace welkin::sh {

/// Number of coefficients of `bands` bands: bands^2.
constexpr int coefficientCount(int bands) {
  return bands * bands;
}

/// Index of degree l and order m, |m| <= l.
constexpr int indexOf(int l, int m) {
  return l * (l + 1) + m;
}

/// The factors N_lm of the basis in spherical coordinates: Y_lm = N_lm cos(m phi) for m >= 0, N_l|m| sin(|m| phi) for
/// m < 0. At polar cosine s and its sine c, N_mm = diagonal(m) c^m and N_lm = climb(l, m) s N_l-1,m - fall(l, m)
/// N_l-2,m. This normalised recurrence in l (Holmes and Featherstone 2002, eq. 11) is stable to hundreds of bands.
class LatitudeRecurrence {
 public:
  explicit LatitudeRecurrence(int bands);

  int bands() const { return static_cast<int>(diagonal_.size()); }
  double diagonal(int m) const { return diagonal_[static_cast<std::size_t>(m)]; }
  double climb(int l, int m) const { return step_[static_cast<std::size_t>(indexOf(l, m))].climb; }
  double fall(int l, int m) const { return step_[static_cast<std::size_t>(indexOf(l, m))].fall; }

  /// Computes all factors at polar cosine `s` = sin(elevation) and its sine `c` = cos(elevation) >= 0. Sets
  /// out[indexOf(l, m)] for m >= 0 only; `out` holds coefficientCount(bands) values.
  void evaluate(double s, double c, std::span<double> out) const;

 private:
  struct Step {
    double climb = 0.0;
    double fall = 0.0;
  };
  std::vector<double> diagonal_;
  std::vector<Step> step_;
};

/// The basis functions at unit `direction`, polar axis z; `out` holds coefficientCount(bands) values.
void evaluateBasis(const LatitudeRecurrence& recurrence, const det::Number3& direction, std::span<double> out);

}  // namespace welkin::sh
