// SPDX-License-Identifier: Apache-2.0
// The volume of texels around the camera.
#pragma once

#include <welkin/volume.h>

#include <array>
#include <cstdint>

#include "probes/far_map.h"
#include "probes/level.h"
#include "probes/volume_cuts.h"

namespace welkin::core {

template <>
inline constexpr std::size_t kFirstSize<WelkinVolumeSettings> = 32;
template <>
inline constexpr std::size_t kFirstSize<WelkinVolumeUpdate> = 320;

}  // namespace welkin::core

namespace welkin::probes {

/// Indices of cells, counted from the world's origin.
using Cells = std::array<std::int64_t, 3>;

/// A texel: one word for each channel, of which RGBA8 uses the lower half. WELKIN_VOLUME_DEVICE has the lower half of
/// the first one alone: kOpenTexel, kDarkTexel, or deviceTexel of a probe.
using TexelWords = std::array<std::uint64_t, kChannels>;

inline constexpr std::uint32_t kOpenTexel = 0, kDarkTexel = 1, kFirstTexel = 2;
inline constexpr std::uint32_t kSlotProbes = 256;  ///< probes that a sector's slot has room for

/// The slot of a sector in the device's memory. Sectors that light one volume's texels have different ones.
std::uint32_t slotOf(const WelkinVolume& volume, std::int32_t x, std::int32_t z);

/// The light of a sector's probe as a texel of the volume. A null sector, one that has gone, is dark.
TexelWords texelOf(const WelkinVolume& volume, const WelkinSector* sector, std::uint32_t probe);

/// The words of a probe's light, [channel][direction], over a scale.
TexelWords packTexel(const float* light, WelkinVolumeFormat format, float scale);
/// The four numbers of such a word, times the scale.
std::array<float, kDirections> unpackTexel(std::uint64_t word, WelkinVolumeFormat format, float scale);

/// Fills the texels of the cells from `low` up to but not including `high`.
void fillCells(WelkinVolume& volume, const WelkinLevel& level, const Cells& low, const Cells& high);
/// Copies the first slice along z to the one after the last.
void copyFirstSlice(WelkinVolume& volume);
/// Fills the texels of the bricks of `count` layers.
void fillBricks(WelkinVolume& volume, std::uint32_t first, std::uint32_t count);

}  // namespace welkin::probes

struct WelkinVolume {
  welkin::core::HostMemory memory;
  WelkinVolumeFormat format = WELKIN_VOLUME_RGBA16F;
  std::array<std::uint32_t, 3> count{};  ///< texels on each axis
  std::uint32_t depth = 0;               ///< slices of the textures: count[2], a copy of the first, and bricks
  std::array<double, 3> texel_m{};
  std::size_t texel_bytes = 0;
  std::size_t channels = welkin::probes::kChannels;  ///< of `texels` that are used; 1 for WELKIN_VOLUME_DEVICE
  welkin::core::HostArray<std::byte> texels[3];
  welkin::core::HostArray<std::uint64_t> slice;  ///< version of the light in each slice along z
  welkin::probes::Cells first{};                 ///< cell of least indices
  std::array<double, 3> camera{};                ///< of the last update, metres
  bool filled = false;
  float scale = 1.0F;                                        ///< irradiance of a texel's value 1
  std::uint64_t version = 0;                                 ///< of the light that texels are filled with
  std::uint32_t next = 0;                                    ///< slice where filling goes on
  welkin::probes::TexelWords open{};                         ///< beyond the resident sectors
  std::array<float, welkin::probes::kColours> open_light{};  ///< likewise, as a probe's light
  std::array<std::uint32_t, 2> slots{};                      ///< of sectors along x and z, for WELKIN_VOLUME_DEVICE
  const WelkinLevel* level = nullptr;                        ///< of the last update
  welkin::probes::VolumeCuts cuts;
  welkin::probes::FarMap far_map;
};
