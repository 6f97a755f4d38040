// SPDX-License-Identifier: Apache-2.0
// The probes of a sector in few bytes: fixed point with scales per probe. Without modes of the sun, as `sun = "sh"`
// needs them, 110 bytes a probe:
//
//     position     3 x u16   x and z in 64 m / 65535 from the sector's corner, y in (high_y - low_y) / 65535 above
//     low_y visibility   3 x u16   in 1 / 65535, of the directions up; that of down is 0 sky_scale        u16   the
//     first 16 bits of a float32 >= 0 sky         48 x i16   in sky_scale / 32767: [direction][coefficient][channel]
//
// with n modes of the sun 2 + 4 n more, 152 with 10:
//
//     sun_scale        u16   as above, times the mode's coefficient_scale
//     sun         4n x i8    in sun_scale coefficient_scale / 127: [direction][mode]
//
// and where the level has emissive surfaces 26 more:
//
//     emitted_scale    u16   as above
//     emitted     12 x u16   in emitted_scale / 65535: [direction][channel]
//
// Once a sector: the modes' knots as float32 hours, every mode as 3 x i8 (RGB) at each knot in mode_scale / 127, and
// two float32 scales a mode.
#pragma once

#include <cstdint>
#include <vector>

#include "probes/sector.h"
#include "probes/transfer/sun_modes.h"
#include "probes/transfer/transfer.h"

namespace welkin::probes {

/// The probes of a sector as numbers. ProbeTransfer::sun is not among them: `sun` and `modes` stand for it.
struct SectorProbes {
  SectorId id;
  std::vector<Number3> position;  ///< metres; x and z within the sector
  std::vector<ProbeTransfer> transfer;
  std::vector<SunCoefficients> sun;  ///< one a probe, each of as many numbers as there are modes
  SunModes modes;
};

/// Arrays as a file holds them: one entry after the other in the order above, probe by probe.
struct EncodedProbes {
  float low_y = 0.0F;
  float high_y = 0.0F;
  std::vector<std::uint16_t> position;
  std::vector<std::uint16_t> visibility;
  std::vector<std::uint16_t> sky_scale;
  std::vector<std::int16_t> sky;
  std::vector<std::uint16_t> sun_scale;  ///< empty without modes
  std::vector<std::int8_t> sun;
  std::vector<std::uint16_t> emitted_scale;  ///< empty where no emitted light reaches a probe
  std::vector<std::uint16_t> emitted;
  std::vector<float> sun_time_h;  ///< knots
  std::vector<float> moon_time_h;
  std::vector<float> coefficient_scale;  ///< [mode]
  std::vector<float> mode_scale;         ///< [mode]
  std::vector<std::int8_t> mode;         ///< [mode][knot][channel], the sun's knots first

  std::size_t probes() const { return sky_scale.size(); }
  std::size_t modes() const { return mode_scale.size(); }
  std::size_t bytesAProbe() const;  ///< 0 without probes
  std::size_t bytes() const;        ///< of all arrays and the two heights
};

/// Throws Error(content) for numbers that are not finite, a visibility outside [0, 1], emitted light below 0 and a
/// position outside the sector.
EncodedProbes encodeProbes(const SectorProbes& probes);

/// Throws Error(content) where arrays do not fit each other.
SectorProbes decodedProbes(const EncodedProbes& encoded, SectorId id);

/// The worst difference between probes and what became of them.
struct EncodingError {
  double position_m = 0.0;  ///< of a component
  double visibility = 0.0;
  double sky = 0.0;      ///< irradiance of a coefficient 1 of the sky
  double sun = 0.0;      ///< irradiance, at a knot, of a light of normal irradiance 1, clamped at 0
  double emitted = 0.0;  ///< irradiance, over the probe's largest
};
EncodingError encodingError(const SectorProbes& probes, const SectorProbes& decoded);

}  // namespace welkin::probes
