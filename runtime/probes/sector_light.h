// SPDX-License-Identifier: Apache-2.0
// The light of one instant, as the probes of a sector need it.
#pragma once

#include <welkin/level.h>

#include <array>
#include <cstdint>

#include "format/sector_check.h"
#include "welkin_generated.h"

namespace welkin::probes {

inline constexpr std::size_t kDirections = 4;  ///< of the transfer basis (shaders/shared/transfer_basis.glsl)

/// Largest number of a SectorLight, and largest scale of a probe. Files and samples may hold up to 1e30 and more.
/// Within these bounds, light stays below 1e37, so no sum of floats overflows or becomes NaN.
inline constexpr double kMostLight = 1e18;
inline constexpr float kMostScale = 1e15F;

/// The part of a SectorLight that is one for all sectors.
struct CommonLight {
  float open[3][3];  ///< upper direction, channel: by a step of visibility
  float sky[4][3];   ///< coefficient, channel: by a step of the sky's transfer
  float local;       ///< factor on light that does not follow the day
};

/// Light of one instant that all sectors share. It has no padding, so its bytes tell whether it changed.
struct LevelLight {
  double time_h = 0.0;
  std::array<std::array<double, 3>, 4> sky{};       ///< radiance in 2 bands, without ground; the factor is applied
  std::array<std::array<double, 3>, 4> light_sh{};  ///< sun and moon in 2 bands, times the factor
  std::array<std::array<double, 3>, 2> light_irradiance{};  ///< of sun and moon, times visible share and factor
  double sky_factor = 1.0;                                  ///< on the light of the sky, in `sky` as well
  double local = 1.0;                                       ///< factor on local light
  CommonLight common{};
};

/// What all sectors share of a light; `sh`: the sun's light goes by the transfer of the sky.
CommonLight commonOf(const LevelLight& light, bool sh);
/// The light of a sample for a level.
LevelLight levelLightOf(const WelkinLevelLight& light, const format::Level& level);

/// That light in the steps of a sector's numbers.
struct SectorLight : CommonLight {
  float mode[2][format::kMostSunModes][3];  ///< light that is up, mode, channel
  std::uint32_t lights;                     ///< lights that are up and have a transfer of their own, 0..2
};
SectorLight sectorLightOf(const LevelLight& light, const format::Sector& sector);

}  // namespace welkin::probes
