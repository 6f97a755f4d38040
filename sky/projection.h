// SPDX-License-Identifier: Apache-2.0
// Projection of the sky's radiance into spherical harmonics by a quadrature made for it, not through a cubemap.
//
// The integrand has a conical cusp at the sun (and a weak one opposite), a layer at the horizon that is as steep as
// exp(b / sin elevation), bends where the gradients' rows are centred, and is symmetric about the sun's vertical plane.
// Gauss-Legendre panels in elevation meet the bends and shrink geometrically towards the horizon, the sun and its
// antipode; in azimuth, from the sun's to the opposite, alpha = h sinh u makes the near-singular distance to the sun,
// sqrt(h^2 + alpha^2), a hyperbolic cosine. Coefficients are accumulated in the sun's frame, where only the cosine
// orders live, and rotated to the world once.
#pragma once

#include <cstddef>
#include <vector>

#include "sh/basis.h"
#include "sh/rotation.h"
#include "sky/hemisphere.h"
#include "sky/sky.h"

namespace welkin::sky {

/// Moments of the sky's radiance at intensity 1, without ground, sun, moon, tint and desaturation.
struct SkyMoments {
  std::vector<Number3> radiance_sh;  ///< bands^2, world axes
  Number3 horizontal_irradiance;     ///< integral of radiance times sin elevation
  std::size_t evaluations = 0;       ///< directions that the quadrature looked at
};

/// Immutable after construction; project may be called from many threads.
class SkyProjector {
 public:
  /// `bands` >= 1. `refinement` >= 1 multiplies the nodes of every panel: 1 keeps every coefficient within 1e-5 of c0
  /// for every named model and sun elevation (tests/sky/projection_test.cpp), 3 is converged to rounding.
  explicit SkyProjector(int bands, int refinement = 1);

  SkyMoments project(const SkyInstant& instant) const;

  /// Irradiance (pi included) of a surface with unit `normal` from the sky at intensity 1, integrated directly: no SH.
  Number3 irradiance(const SkyInstant& instant, const Number3& normal) const;

 private:
  int bands_;
  const HemisphereQuadrature& quadratureFor(const SkyInstant& instant) const;

  HemisphereQuadrature quadrature_;
  HemisphereQuadrature fading_;  ///< where gradients are black
  sh::LatitudeRecurrence recurrence_;
  sh::Rotation to_world_;
};

}  // namespace welkin::sky
