// SPDX-License-Identifier: Apache-2.0
// Dynamic lights on a random level, and the double reference of their light on its probes.
#pragma once

#include <vector>

#include "probes/transfer/local_relight.h"
#include "tests/runtime/random_level.h"

namespace welkin::tests {

/// Of one probe: channel by direction of the transfer basis, as WelkinColours.
using ProbeColours = std::array<f64::Number3, 4>;

/// The light that the reference gives every probe, by sector. Beyond 64 m no virtual light sees a lamp.
struct ReferenceLight {
  std::vector<std::vector<ProbeColours>> sector;
  std::size_t unseen = 0;
  double largest = 0.0;  ///< channel
};
ReferenceLight referenceLight(const RandomLevel& level, const std::vector<WelkinPointLight>& lamps,
                              const transfer::SeeEachOther& see);

/// The light of dynamic lights alone on a probe of an opened level, from the middle of a cell that names it.
WelkinColours lightOfProbe(const RandomLevel& level, const OpenedLevel& opened, std::size_t sector, std::size_t probe);
std::vector<WelkinColours> lightOfProbes(const RandomLevel& level, const OpenedLevel& opened);

/// Sets lights and relights all probes by them alone.
WelkinLightsResult setLamps(OpenedLevel& opened, const std::vector<WelkinPointLight>& lamps, WelkinSees sees = nullptr,
                            void* user = nullptr);

WelkinPointLight lampAt(const f64::Number3& position, const f64::Number3& intensity);
WelkinPointLight spotAt(const f64::Number3& position, const f64::Number3& intensity, const f64::Number3& axis,
                        double inner_rad, double outer_rad);

/// A virtual light's place in the world as the runtime knows it, from the list of one sector.
f64::Number3 virtualLightOf(const RandomLevel& level, std::size_t sector, std::size_t light);

}  // namespace welkin::tests
