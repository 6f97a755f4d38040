// SPDX-License-Identifier: Apache-2.0
// Real spherical harmonics of any number of bands: orthonormal, no Condon-Shortley phase, index l (l + 1) + m.
// The closed forms of shaders/shared/sh.glsl are the first five bands of the same functions.
#pragma once

#include <span>

#include "sh/deterministic.h"

namespace welkin::sh {

/// Number of coefficients of `bands` bands: their square.
constexpr int coefficientCount(int bands) {
  return bands * bands;
}

/// Index of degree l and order m, |m| <= l.
constexpr int indexOf(int l, int m) {
  return l * (l + 1) + m;
}

/// The basis functions at unit `direction`, polar axis z; `out` holds coefficientCount(bands) values.
void evaluateBasis(int bands, const det::Number3& direction, std::span<double> out);

/// The factors N_lm(s) of the basis in spherical coordinates, Y_lm = N_lm(s) cos(m phi) for m >= 0 and N_l|m| sin(|m|
/// phi) for m < 0, at polar cosine s = sin(elevation) and its sine c = cos(elevation) >= 0. `out[indexOf(l, m)]` is set
/// for m >= 0 only. Normalised recurrence in l (Holmes and Featherstone 2002, eq. 11): stable to hundreds of bands.
void evaluateLatitudeFactors(int bands, double s, double c, std::span<double> out);

}  // namespace welkin::sh
