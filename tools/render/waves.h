// SPDX-License-Identifier: Apache-2.0
// A calm sea as a sum of waves that is the same for the same hour on every machine.
#pragma once

#include <array>

#include "render/shaders/level_constants.h"

namespace welkin::render {

/// Wave vector (east, south; 1/m), slope, phase at the hour; radians. Wave lengths from a quarter of a metre to twenty,
/// running with a light wind from the east; deep water, so the angular frequency is sqrt(g k).
std::array<std::array<float, 4>, WELKIN_WAVE_COUNT> wavesAt(double time_h);

/// Variance of the slopes of ripples shorter than those waves, along either axis. With the waves' own 1.5e-3 it is that
/// of a wind of less than 1 m/s (Cox and Munk 1954: 0.003 + 0.00512 w for both axes).
inline constexpr double kRippleVariance = 1.2e-3;

}  // namespace welkin::render
