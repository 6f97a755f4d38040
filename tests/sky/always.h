// SPDX-License-Identifier: Apache-2.0
// What holds for every sky, instant and direction of the domain: no NaN, no infinity, no negative radiance or
// irradiance, from the model and from the runtime, and no step in time or direction.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "baked.h"
#include "sky/model/sky.h"

namespace welkin::tests {

using det::Number3;

/// What is wrong, in words; empty: nothing.
using Fault = std::string;

/// Of the model at an instant, in a unit direction: the shape, the dome over a ground of radiance 1, and the ground.
Fault faultOfModel(const model::SkyInstant& instant, const Number3& direction);

/// Of all numbers of a sample.
Fault faultOfSample(const WelkinSkySample& sample);

/// Of what the runtime makes of a sample in a unit direction: dome, discs, stars, and the irradiance of a surface that
/// faces it.
Fault faultOfDirection(const welkin::Sky& sky, const WelkinSkySample& sample, const Number3& direction);

/// A colour whose changes are measured: against its own largest component, or against `size` where that is larger.
struct Shown {
  Number3 colour;
  double size = 0.0;
};

/// The model's dome. A channel's rounding is that of the brightest before the tint, whatever the tint makes of them:
/// the size is the brightest channel under the largest tint.
Shown domeOf(const model::SkyInstant& instant, const Number3& direction);

/// The runtime's dome, and irradiance by its SH, whose sum cancels: its size is the mean irradiance.
std::vector<Shown> seen(const welkin::Sky& sky, const WelkinSkySample& sample, const Number3& direction);

/// Zenith, nadir, four on the horizon and one unit above and below it, and those that matter for a sun: towards it,
/// away from it, and at its azimuth on the horizon.
std::vector<Number3> specialDirections(const Number3& sun);

/// A change between two places.
struct Step {
  double height = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// The largest step of colours as functions of one variable that is left when [low, high] is halved until it is
/// `resolution` wide, always where they change more: the height of a step, and about slope times resolution where there
/// is none. Relative to the largest size that was met of each, absolute when that is below 1e-30.
Step largestStep(const std::function<std::vector<Shown>(double)>& function, double low, double high, double resolution);

}  // namespace welkin::tests
