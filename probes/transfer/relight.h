// SPDX-License-Identifier: Apache-2.0
// A probe's irradiance at one time, from its transfer and the light of that time: the reference, in double, of what the
// runtime does. Stefanov, "Deferred Radiance Transfer Volumes" (GDC 2012).
#pragma once

#include <array>
#include <vector>

#include "probes/transfer/sun_modes.h"
#include "probes/transfer/transfer.h"

namespace welkin::transfer {

using f64::Number3;

/// Where the bounced light of sun and moon comes from.
enum class SunTransfer {
  none,        ///< nowhere
  sh,          ///< the sky's transfer, with the light projected into 2 bands
  directional  ///< its own, along its path
};

/// Sun or moon at a time.
struct LightAt {
  Number3 direction{0, 1, 0};  ///< unit; below the horizon it gives nothing
  Number3 irradiance{0.0};     ///< of a surface that faces it, scene units
};

/// Factors of the artist: [scale] of level.toml.
struct RelightScale {
  double sky = 1.0;
  double sun_bounce = 1.0;
};

/// The radiance over the upper hemisphere that its 2 bands stand for, where the bounced light of the sky is concerned.
enum class SkyBounce {
  projected,  ///< the bands' own sum, as in the talk: of a uniform sky it is 1/2 + 3 y / 4
  fitted      ///< the sum of the four functions that is nearest to it over the upper hemisphere alone
};

/// Coefficients a of the sum of Y_k nearest in the mean square, over the upper hemisphere, to the radiance there of
/// which `sh` are the coefficients, the lower hemisphere black: `sh` times the inverse of the functions' inner products
/// over the hemisphere. Exact for every radiance that is linear in the direction.
std::array<Number3, 4> fittedToHemisphere(const std::array<Number3, 4>& sh);

/// What all probes of a sector share at one time.
struct Relight {
  /// Radiance of the sky, 2 bands, index l (l + 1) + m: upper hemisphere only, without ground, desaturated.
  std::array<Number3, 4> sky{};
  std::array<Number3, 4> bounced_sky{};  ///< by SkyBounce
  SunTransfer sun_transfer = SunTransfer::none;
  std::array<Number3, 4> light_sh{};          ///< sh: of sun and moon
  std::array<std::vector<Number3>, 2> mode;   ///< directional: modesAt of sun and moon
  std::array<Number3, 2> light_irradiance{};  ///< directional: of sun and moon; 0 below the horizon
  RelightScale scale;
};

/// At a finite time. `modes` counts for `directional` only.
Relight relightAt(double time_h, const std::array<Number3, 4>& sky_sh, const LightAt& sun, const LightAt& moon,
                  SunTransfer sun_transfer, const SunModes& modes, const RelightScale& scale = {},
                  SkyBounce sky_bounce = SkyBounce::projected);

/// Irradiance by direction of the transfer basis, pi included.
struct ProbeIrradiance {
  std::array<Number3, kDirections> sky{};         ///< direct and bounced
  std::array<Number3, kDirections> sun_bounce{};  ///< and the moon's; by `sh` it may be below 0
  std::array<Number3, kDirections> local{};       ///< of emissive surfaces
  std::array<Number3, kDirections> total() const;
};

/// `sun`: coefficients of the modes; they count for `directional` only.
ProbeIrradiance relit(const ProbeTransfer& transfer, const SunCoefficients& sun, const Relight& light);

}  // namespace welkin::transfer
