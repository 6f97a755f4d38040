// SPDX-License-Identifier: Apache-2.0
// The slow reference of the projection: other coordinates, the C++ library's functions, far more nodes.
#pragma once

#include <vector>

#include "sky/model/sky.h"

namespace welkin::tests {

using det::Number3;

struct Reference {
  std::vector<Number3> radiance_sh;
  Number3 horizontal_irradiance;
};

/// Integrates in polar coordinates about the sun by composite Gauss-Legendre, graded to the cusps and to the horizon's
/// clip. It is for skies of one colour, because the gradients' bends are circles about the zenith. Converged to 2e-8 of
/// c0, or 1e-6 with the sun on the horizon, where clip and cusp meet.
Reference referenceAboutSun(const model::SkyInstant& instant, int bands);

/// Integrates by the midpoint rule over elevation and azimuth in the world's frame, with `n` x 4 n nodes. `normal` puts
/// the irradiance of a surface in place of `horizontal_irradiance`. It works for any sky; the error falls with the
/// square of n.
Reference referenceOverWorld(const model::SkyInstant& instant, int bands, int n,
                             const Number3& normal = {0.0, 1.0, 0.0});

}  // namespace welkin::tests
