// SPDX-License-Identifier: Apache-2.0
// Compact fixed-point encoding of a sector's probes, as the file stores them.
//
// Without modes of the sun, as with `sun = "sh"`, a probe takes 62 bytes:
//
// - position, 3 x u16: x and z in 64 m / 65535 from the sector's corner, y in (high_y - low_y) / 65535 above low_y
// - visibility, 3 x u16: in 1 / 65535, for the three directions up; for down it is 0
// - sky_scale, u16: the upper 16 bits of a float32 >= 0
// - sky, 24 x u8: in sky_scale / 255, [direction][coefficient 0, 1][channel]. These are never below 0, because nothing
//   arrives from below the horizon.
// - sky_side, 24 x i8: in sky_scale / 127, [direction][coefficient 2, 3][channel]
//
// With n modes of the sun it takes 2 + 4 n more, 104 with 10 modes:
//
// - sun_scale, u16: as above, times the mode's coefficient_scale
// - sun, 4n x i8: in sun_scale coefficient_scale / 127, [direction][mode]
//
// Where emissive surfaces or the level's own lights send light, it takes 14 more:
//
// - emitted_scale, u16: as above
// - emitted, 12 x u8: in emitted_scale / 255, [direction][channel]
//
// Each sector stores once: the two heights as float32, and the modes' knots as float32 hours. Every mode takes 3 x i8
// (RGB) at each knot, in mode_scale / 127, and two float32 scales. docs/probes.md gives the errors of fewer and of more
// bits.
#pragma once

#include <cstdint>
#include <vector>

#include "probes/geometry/sector.h"
#include "probes/transfer/sun_modes.h"
#include "probes/transfer/transfer.h"

namespace welkin::transfer {

using f64::Number3;

/// The probes of a sector as numbers. `sun` and `modes` stand for ProbeTransfer::sun, which is not encoded.
struct SectorProbes {
  geometry::SectorId id;
  std::vector<Number3> position;  ///< metres; x and z within the sector
  std::vector<ProbeTransfer> transfer;
  std::vector<SunCoefficients> sun;  ///< one entry per probe, each with one number per mode
  SunModes modes;
};

/// Bytes of a sector's probes, by content.
struct ProbeBytes {
  std::size_t position = 0, visibility = 0, sky = 0, sun = 0, emitted = 0;
  std::size_t scales = 0;   ///< of all probes
  std::size_t heights = 0;  ///< stored once per sector
  std::size_t modes = 0;    ///< stored once per sector: knots, scales and values

  std::size_t ofProbes() const { return position + visibility + sky + sun + emitted + scales; }
  std::size_t total() const { return ofProbes() + heights + modes; }
};

/// Arrays as the file stores them, probe by probe in the order above.
struct EncodedProbes {
  float low_y = 0.0F;
  float high_y = 0.0F;
  std::vector<std::uint16_t> position;
  std::vector<std::uint16_t> visibility;
  std::vector<std::uint16_t> sky_scale;
  std::vector<std::uint8_t> sky;
  std::vector<std::int8_t> sky_side;
  std::vector<std::uint16_t> sun_scale;  ///< empty without modes
  std::vector<std::int8_t> sun;
  std::vector<std::uint16_t> emitted_scale;  ///< empty where no emitted light reaches a probe
  std::vector<std::uint8_t> emitted;
  std::vector<float> sun_time_h;  ///< knots
  std::vector<float> moon_time_h;
  std::vector<float> coefficient_scale;  ///< [mode]
  std::vector<float> mode_scale;         ///< [mode]
  std::vector<std::int8_t> mode;         ///< [mode][knot][channel], the sun's knots first

  std::size_t probes() const { return sky_scale.size(); }
  std::size_t modes() const { return mode_scale.size(); }
  ProbeBytes bytes() const;
  std::size_t bytesAProbe() const { return probes() == 0 ? 0 : bytes().ofProbes() / probes(); }
};

/// Encodes the probes. Throws Error(content) if a number is not finite, a visibility is outside [0, 1], coefficient 0
/// or 1 of the sky or emitted light is below 0, or a position is outside the sector.
EncodedProbes encodeProbes(const SectorProbes& probes);

/// Decodes the probes. Throws Error(content) if the sizes of the arrays do not match.
SectorProbes decodedProbes(const EncodedProbes& encoded, geometry::SectorId id);

}  // namespace welkin::transfer
