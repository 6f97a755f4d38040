// SPDX-License-Identifier: Apache-2.0
// A probe's irradiance at one time, from its transfer and the light of that time. It is the double-precision reference
// for the runtime. Stefanov, "Deferred Radiance Transfer Volumes" (GDC 2012).
#pragma once

#include <array>
#include <vector>

#include "probes/transfer/sun_modes.h"
#include "probes/transfer/transfer.h"

namespace welkin::transfer {

using f64::Number3;

/// Source of the bounced light of sun and moon.
enum class SunTransfer {
  none,        ///< no bounced light
  sh,          ///< the sky's transfer, with the light projected into 2 bands
  directional  ///< the light's own transfer along its path
};

/// The sun or the moon at one time.
struct LightAt {
  Number3 direction{0, 1, 0};  ///< unit; a light below the horizon gives nothing
  Number3 irradiance{0.0};     ///< of a surface that faces it, scene units
};

/// The artist's factors, [scale] of level.toml.
struct RelightScale {
  double sky = 1.0;
  double sun_bounce = 1.0;
};

/// How the 2 bands of the sky stand for its radiance over the upper hemisphere, for bounced light.
enum class SkyBounce {
  projected,  ///< sum of the bands, as in Stefanov's talk: 1/2 + 3 y / 4 for a uniform sky
  fitted      ///< the sum of the four functions nearest to the radiance over the upper hemisphere alone
};

/// Least-squares fit over the upper hemisphere. `sh` are the coefficients of a radiance that is black in the lower
/// hemisphere. The result gives the sum of Y_k nearest to that radiance in the mean square over the upper hemisphere:
/// `sh` times the inverse of the functions' inner products there. Exact for radiance that is linear in the direction.
std::array<Number3, 4> fittedToHemisphere(const std::array<Number3, 4>& sh);

/// The light that all probes of a sector share at one time.
struct Relight {
  /// Radiance of the sky, 2 bands, index l (l + 1) + m: upper hemisphere only, without ground, desaturated.
  std::array<Number3, 4> sky{};
  std::array<Number3, 4> bounced_sky{};  ///< the sky for bounced light, by SkyBounce
  SunTransfer sun_transfer = SunTransfer::none;
  std::array<Number3, 4> light_sh{};          ///< for `sh`: sun and moon
  std::array<std::vector<Number3>, 2> mode;   ///< for `directional`: modesAt of sun and moon
  std::array<Number3, 2> light_irradiance{};  ///< for `directional`: of sun and moon; 0 below the horizon
  RelightScale scale;
};

/// The light at a finite time. `modes` matters for `directional` only.
Relight relightAt(double time_h, const std::array<Number3, 4>& sky_sh, const LightAt& sun, const LightAt& moon,
                  SunTransfer sun_transfer, const SunModes& modes, const RelightScale& scale = {},
                  SkyBounce sky_bounce = SkyBounce::projected);

/// Irradiance by direction of the transfer basis, pi included.
struct ProbeIrradiance {
  std::array<Number3, kDirections> sky{};         ///< direct and bounced
  std::array<Number3, kDirections> sun_bounce{};  ///< with the moon's; with `sh` it may be below 0
  std::array<Number3, kDirections> local{};       ///< from emissive surfaces and the level's own lights
  std::array<Number3, kDirections> total() const;
};

/// Irradiance of a probe. `sun` are its coefficients of the modes; they matter for `directional` only.
ProbeIrradiance relit(const ProbeTransfer& transfer, const SunCoefficients& sun, const Relight& light);

}  // namespace welkin::transfer
