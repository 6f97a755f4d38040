// SPDX-License-Identifier: Apache-2.0
// The mildest window that keeps irradiance from few bands non-negative. The idea is Sloan's, "Deringing Spherical
// Harmonics" (SIGGRAPH Asia 2017 technical briefs): use the mildest window of a family that the sky allows.
#pragma once

#include <array>
#include <span>

#include "sh/deterministic.h"

namespace welkin::sh {

/// Factors of the bands l = 0..4, (1 - strength)^(l (l + 1) / 2). This is diffusion over the sphere, exp(-t l (l + 1)),
/// written without exp. Its kernel is positive, and a stronger window equals a milder one followed by diffusion. So the
/// least value over the sphere never falls as the strength grows. Other families, such as 1 / (1 + t l^2 (l + 1)^2),
/// can turn a positive value negative. With 3 and 5 bands that family also adds about twice the error to clear skies.
struct Window {
  double strength = 0.0;  ///< 0: all bands as they are; 1: only the mean is left
  std::array<double, 5> factor = {1.0, 1.0, 1.0, 1.0, 1.0};
};

/// The window of `strength`, in [0, 1].
Window windowOf(double strength);

/// Irradiance may be below 0 by this share of its mean over all normals, which single precision does not resolve.
inline constexpr double kWindowTolerance = 1e-7;

/// The window of least strength that keeps the irradiance of every set at all `normals` at or above -kWindowTolerance
/// of its mean. The strength is exactly 0 if no set needs more. `radiance`: one or more sets of bands^2 coefficients,
/// world axes, the first coefficient of a set >= 0; `bands` in [2, 5]. Bisection finds the strength to 2^-40, and the
/// result has been checked. It uses only + - * /, and so has the same bits on every machine.
Window mildestWindow(std::span<const double> radiance, int bands, std::span<const det::Number3> normals);

}  // namespace welkin::sh
