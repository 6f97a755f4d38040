// SPDX-License-Identifier: Apache-2.0
// Checks of properties that hold for every sky, instant and direction of the domain: no NaN, no infinity, no negative
// radiance or irradiance, from the model and from the runtime, and no step in time or direction.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "baked.h"
#include "sky/model/sky.h"

namespace welkin::tests {

using det::Number3;

/// Description of the fault. Empty if there is none.
using Fault = std::string;

/// Checks the model at an instant, in a unit direction: the shape, the dome over a ground of radiance 1, and the
/// ground.
Fault faultOfModel(const model::SkyInstant& instant, const Number3& direction);

/// Checks all numbers of a sample.
Fault faultOfSample(const WelkinSkySample& sample);

/// Checks the runtime's results for a sample in a unit direction: dome, discs, stars, and the irradiance of a surface
/// that faces it.
Fault faultOfDirection(const welkin::Sky& sky, const WelkinSkySample& sample, const Number3& direction);

/// A colour whose changes are measured: against its own largest component, or against `size` where that is larger.
struct Shown {
  Number3 colour;
  double size = 0.0;
};

/// The model's dome. The size is the brightest channel under the largest tint, because the brightest channel before the
/// tint determines the rounding of all.
Shown domeOf(const model::SkyInstant& instant, const Number3& direction);

/// The runtime's dome and its irradiance from SH. The terms of that sum cancel, so its size is the mean irradiance.
std::vector<Shown> seen(const welkin::Sky& sky, const WelkinSkySample& sample, const Number3& direction);

/// Zenith, nadir, four directions on the horizon and one unit above and below it. For the sun: towards it, away from
/// it, and at its azimuth on the horizon.
std::vector<Number3> specialDirections(const Number3& sun);

/// A change between two places.
struct Step {
  double height = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// The largest remaining step of colours as functions of one variable, when [low, high] is halved down to `resolution`.
/// Each halving keeps the half where they change more. The result is the height of a step, or about slope times
/// resolution where there is none. It is relative to the largest size met of each colour, and absolute when that size
/// is below 1e-30.
Step largestStep(const std::function<std::vector<Shown>(double)>& function, double low, double high, double resolution);

}  // namespace welkin::tests
