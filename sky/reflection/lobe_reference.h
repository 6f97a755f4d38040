// SPDX-License-Identifier: Apache-2.0
// The lobe's mean radiance by quadrature of the radiance itself, in double: what filters are measured against.
#pragma once

#include "sky/reflection/cube_pyramid.h"

namespace welkin::reflection {

/// Gauss-Legendre nodes of a panel, in the angle from the axis and around it.
struct LobeNodes {
  int out = 24;
  int around = 24;
};

/// Mean radiance of the lobe of `power` in [1, 8192] about a unit axis. Circles around the axis are cut where they
/// cross the horizon, y = 0, and the angle where they touch it. So a step at the horizon costs no accuracy. The lobe
/// ends where it is below 1e-9 of its peak, or at 90 degrees. A radiance that is analytic on each side of the horizon
/// comes out to 1e-9. Doubling the nodes shows the error of another one.
Number3 lobeReference(const Radiance& radiance, double power, const Number3& axis, const LobeNodes& nodes = {});

}  // namespace welkin::reflection
