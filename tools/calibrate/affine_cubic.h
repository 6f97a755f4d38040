// SPDX-License-Identifier: Apache-2.0
// An affine map, a cubic of every channel, an affine map, in xyY: the sequence of S. McAuley, "Calibrating lighting and
// materials in Far Cry 3", SIGGRAPH course Practical Physically Based Shading, 2012.
#pragma once

#include "calibrate/model.h"

namespace welkin::calibrate {

/// Three gains; an affine map (nine factors and three sums, row by row); for x, y and Y the ends of the chart's range
/// and the four coefficients of a cubic; an affine map.
inline constexpr std::size_t kAffineCubicNumbers = 3 + 12 + 3 * 6 + 12;

/// Fits one stage after the other, each by least squares of what the last one left. Gains of the channels come first,
/// since xyY of a photograph without white balance is no affine map away. A cubic that would not rise over the chart's
/// range gives way to one of lower degree, and a stage that the pairs do not determine changes nothing. None if a
/// channel is 0 in all pairs or the chromaticities of the pairs lie on a line. A refit after a change of exposure gives
/// the same colours.
std::optional<std::vector<double>> fitAffineCubic(std::span<const Pair> pairs);

/// Past the chart's range a cubic goes on along its tangent. y is at least 0.02, and x, y and 1 - x - y are at least 0.
Colour applyAffineCubic(std::span<const double> numbers, const Colour& measured);

/// Sum of the squared differences of x, y and Y over all pairs, which no stage makes larger.
double squaresInXyY(std::span<const Pair> pairs, const Model& model);

}  // namespace welkin::calibrate
