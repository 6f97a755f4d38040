// SPDX-License-Identifier: Apache-2.0
// The numbers of a sector's probes in blocks of eight, so that vector instructions read them.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/host_memory.h"
#include "probes/sector_light.h"
#include "welkin_generated.h"

namespace welkin::probes {

inline constexpr std::size_t kBlock = 8;  ///< probes
inline constexpr std::size_t kChannels = 3;
/// Numbers of a probe's light: channel, direction.
inline constexpr std::size_t kColours = kChannels * kDirections;

/// Order and size of a block. Every array holds one number of each of the eight probes, side by side.
struct BlockLayout {
  std::size_t modes;

  static constexpr std::size_t kScales = 0;                          // float: of the sky, then of the sun
  static constexpr std::size_t kVisibility = 2 * kBlock * 4;         // u16: upper direction
  static constexpr std::size_t kSky = kVisibility + 3 * kBlock * 2;  // u8: direction, coefficient 0 or 1, channel
  static constexpr std::size_t kSide = kSky + 24 * kBlock;           // i8: direction, coefficient 2 or 3, channel
  static constexpr std::size_t kSun = kSide + 24 * kBlock;           // i8: direction, mode
  std::size_t bytes() const { return kSun + kDirections * modes * kBlock; }
};

/// Packs the probes of a sector that sectorFaultOf let pass. Numbers of probes that fill up the last block are 0. False
/// when memory runs out.
bool packProbes(const format::Probes& probes, const core::HostMemory& memory, core::HostArray<std::byte>& blocks);

/// Light of emissive surfaces and of the level's own lights: [probe][channel][direction]. Stays empty where there is
/// none. False when memory runs out.
bool unpackEmitted(const format::Probes& probes, const core::HostMemory& memory, core::HostArray<float>& light);
/// Adds that light to `light`.
void addEmitted(const format::Probes& probes, float* light);

/// Irradiance of `count` probes from `first` on, by channel and direction: `out` is of the sector's first probe.
/// `fixed` is the light that does not follow the day, likewise, or null. Additions and multiplications have one order
/// on every processor, so the bits are the same.
void relightProbes(const std::byte* blocks, std::size_t modes, const SectorLight& light, const float* fixed,
                   std::size_t first, std::size_t count, float* out);

}  // namespace welkin::probes
