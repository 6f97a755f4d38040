// SPDX-License-Identifier: Apache-2.0
// The mildest window that keeps irradiance from few bands non-negative, after the idea of Sloan, "Deringing Spherical
// Harmonics" (SIGGRAPH Asia 2017 technical briefs): not a fixed window, but the least of a family that the sky needs.
#pragma once

#include <array>
#include <span>

#include "sh/deterministic.h"

namespace welkin::sh {

/// Factors of the bands l = 0..4, (1 - strength)^(l (l + 1) / 2). That is diffusion over the sphere, exp(-t l (l + 1)),
/// written so that it takes no exp. Why this family: its kernel is positive, and a stronger window is a milder one and
/// diffusion after it, so the least value over the sphere never falls as the strength grows. Others, such as
/// 1 / (1 + t l^2 (l + 1)^2), can make a value that was positive negative; with 3 and 5 bands that one also adds about
/// twice the error to clear skies.
struct Window {
  double strength = 0.0;  ///< 0: all bands as they are; 1: only the mean is left
  std::array<double, 5> factor = {1.0, 1.0, 1.0, 1.0, 1.0};
};

/// The window of `strength`, in [0, 1].
Window windowOf(double strength);

/// How far below 0 irradiance may be, of its mean over all normals: below what single precision tells apart.
inline constexpr double kWindowTolerance = 1e-7;

/// The least strength at which the irradiance of every set of coefficients is at least -kWindowTolerance of its mean at
/// all `normals`; 0 exactly when nothing needs more. `radiance`: bands^2 coefficients a set, world axes, of which the
/// first is >= 0; 2 to 5 bands. Found by bisection to 2^-40; what is returned has been checked. Only + - * /: the same
/// bits on every machine.
Window mildestWindow(std::span<const double> radiance, int bands, std::span<const det::Number3> normals);

}  // namespace welkin::sh
