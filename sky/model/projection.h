// SPDX-License-Identifier: Apache-2.0
// Projection of the sky's radiance into spherical harmonics by a quadrature made for it, not through a cubemap.
//
// The integrand has a conical cusp at the sun (and a weak one opposite) and a layer at the horizon as steep as exp(b /
// sin elevation). It bends at the centres of the gradients' rows and is symmetric about the sun's vertical plane.
// Gauss-Legendre panels in elevation meet the bends and shrink geometrically towards the horizon, the sun and its
// antipode. Panels in the tangent of half the azimuth, from the sun's to the opposite, do the same. Coefficients are
// accumulated in the sun's frame, which has only the cosine orders, and rotated to the world once.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sh/basis.h"
#include "sh/rotation.h"
#include "sky/model/hemisphere.h"
#include "sky/model/sky.h"

namespace welkin::model {

using det::Number3;

/// Moments of the sky's radiance at intensity 1, without ground, sun, moon, tint and desaturation.
struct SkyMoments {
  std::vector<Number3> radiance_sh;  ///< bands^2, world axes
  Number3 horizontal_irradiance;     ///< integral of radiance times sin elevation
  std::size_t evaluations = 0;       ///< number of directions evaluated by the quadrature
};

/// The same moments in the frame of the sun's azimuth: pole +y, azimuth counted from the sun's. Only orders m >= 0 are
/// stored, because the sky is symmetric about the sun's vertical plane. Index: polarIndex(l, m).
struct PolarMoments {
  std::vector<Number3> radiance_sh;  ///< bands (bands + 1) / 2
  Number3 horizontal_irradiance;
  std::size_t evaluations = 0;
};

/// Index of the coefficient of degree l and order 0 <= m <= l, when only m >= 0 are stored.
constexpr std::size_t polarIndex(int l, int m) {
  return static_cast<std::size_t>(l * (l + 1) / 2 + m);
}

/// Adds the share of a circle. `order` holds the half integrals of its radiance against cos(m alpha); `factor` holds
/// the latitude's factors of the basis (sh::LatitudeRecurrence).
void addMoments(const Latitude& at, std::span<const Number3> order, std::span<const double> factor, int bands,
                PolarMoments& moments);

/// The bake's bound for the error of every coefficient, relative to c0.
inline constexpr double kTolerance = 1e-5;

/// Immutable after construction. Many threads may call project at once.
class SkyProjector {
 public:
  /// For skies of `model`; `bands` >= 1. Every coefficient is kept within `tolerance` of c0, for every sun elevation
  /// (tests/sky/projection_test.cpp). The levels are 1e-4, 1e-5, 1e-9 and 1e-12, the last being what rounding allows. A
  /// tolerance in between takes the next finer level.
  SkyProjector(const LuminanceModel& model, int bands, double tolerance = kTolerance);

  SkyMoments project(const SkyInstant& instant) const;
  PolarMoments projectPolar(const SkyInstant& instant) const;

  /// Irradiance (pi included) of a surface with unit `normal` from the sky at intensity 1, by direct integration
  /// without SH.
  Number3 irradiance(const SkyInstant& instant, const Number3& normal) const;

 private:
  int bands_;
  HemisphereQuadrature quadrature_;
  sh::LatitudeRecurrence recurrence_;
  sh::Rotation to_world_;
  std::optional<IndicatrixTable> table_;
};

}  // namespace welkin::model
