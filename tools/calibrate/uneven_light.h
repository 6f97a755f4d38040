// SPDX-License-Identifier: Apache-2.0
// Light that falls off over a chart, found by the colours that its patches should have.
#pragma once

#include "calibrate/calibration.h"

namespace welkin::calibrate {

/// Light over the area of patches: exp(along x + down y), with x and y from -1/2 to 1/2 over its width and height. So
/// the light's mean logarithm is 0, and exp(along) is the right edge's light by the left edge's.
struct LightGradient {
  double along = 0.0;
  double down = 0.0;

  /// Light at the middle of a patch.
  double at(std::size_t patch) const;
};

/// The gradient under which the used patches fit the model curve-affine best, by least squares in L*a*b*. It is the
/// same for all channels. Both numbers lie in [-kMostGradient, kMostGradient].
LightGradient gradientOf(const Patches& patches, const ReferenceChart& reference, const std::vector<std::size_t>& used);
inline constexpr double kMostGradient = 1.4;  ///< light of one edge 4 times the other's: patches then have steps of 2

/// The patches as they would look under even light.
Patches withoutGradient(Patches patches, const LightGradient& gradient);

}  // namespace welkin::calibrate
