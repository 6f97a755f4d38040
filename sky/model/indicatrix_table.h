// SPDX-License-Identifier: Apache-2.0
// The indicatrix' exponential from a table. It avoids the arc tangent and the exponential, which are half the cost of
// integrating a sky.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "sh/deterministic.h"

namespace welkin::model {

/// exp(d theta) over theta in [0, pi], as cubics in sin(theta / 2) up to a right angle and in cos(theta / 2) past it.
/// Valid for -kSteepest <= d < 0. The absolute error is at most kError (tests/sky/luminance_test.cpp sweeps it). The
/// slow reference is det::exp of det::angleBetween. The bits are the same on every machine.
class IndicatrixTable {
 public:
  static constexpr double kSteepest = 16.0;
  static constexpr double kError = 1e-10;

  explicit IndicatrixTable(double d);

  /// Takes sin^2 and cos^2 of half the angle, which add up to 1.
  double exponential(double half_sine2, double half_cosine2) const {
    const bool facing = half_sine2 <= half_cosine2;
    return valueOf(facing ? from_sun_ : from_antipode_, std::sqrt(facing ? half_sine2 : half_cosine2));
  }

 private:
  struct Cubic {
    double c0, c1, c2, c3;
  };
  static std::vector<Cubic> tabulate(double d, double scale, int intervals);
  double valueOf(const std::vector<Cubic>& cubics, double x) const {
    const double place = x * intervals_per_unit_;
    const std::size_t i = std::min(static_cast<std::size_t>(place), cubics.size() - 1);
    const double u = place - static_cast<double>(i);
    const Cubic& c = cubics[i];
    return c.c0 + u * (c.c1 + u * (c.c2 + u * c.c3));
  }

  double intervals_per_unit_;
  std::vector<Cubic> from_sun_, from_antipode_;
};

}  // namespace welkin::model
