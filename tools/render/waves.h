// SPDX-License-Identifier: Apache-2.0
// A calm sea as a sum of waves. The same hour gives the same waves on every machine.
#pragma once

#include <array>

#include "render/shaders/level_constants.h"

namespace welkin::render {

/// Each wave has a wave vector (east, south; 1/m), a slope, and its phase at the hour in radians. Wave lengths range
/// from a quarter of a metre to twenty. The waves run with a light wind from the east in deep water, so the angular
/// frequency is sqrt(g k).
std::array<std::array<float, 4>, WELKIN_WAVE_COUNT> wavesAt(double time_h);

/// Variance of the slopes of ripples shorter than those waves, along either axis. Together with the waves' own 1.5e-3
/// it matches a wind of less than 1 m/s (Cox and Munk 1954: 0.003 + 0.00512 w for both axes).
inline constexpr double kRippleVariance = 1.2e-3;

}  // namespace welkin::render
