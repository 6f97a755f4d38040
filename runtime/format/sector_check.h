// SPDX-License-Identifier: Apache-2.0
// Checks the file of a sector and the index of a level before anything reads them: every field is there, every length
// fits the other fields, every number and every index is in its range. It allocates nothing and throws nothing.
#pragma once

#include "welkin_generated.h"

namespace welkin::format {

inline constexpr std::uint32_t kGridCells = 4096;           ///< per sector
inline constexpr std::uint32_t kMostProbes = 255;           ///< per sector
inline constexpr std::uint8_t kNoProbe = 255;               ///< value of a cell without a probe
inline constexpr std::uint32_t kTopCells = 256;             ///< per sector
inline constexpr std::uint32_t kMostRooms = 254;            ///< per sector
inline constexpr std::uint32_t kMostNamedPlaces = 32;       ///< per sector
inline constexpr std::uint32_t kMostSunModes = 16;          ///< per sector
inline constexpr std::uint32_t kMostLocalLights = 128;      ///< per probe
inline constexpr std::uint32_t kMostVirtualLights = 65536;  ///< per sector
inline constexpr std::int32_t kFarthestSector = 15625;

/// A faulty part and the rule that it breaks, such as "the grid" and "must have 4096 cells".
struct Fault {
  const char* what = nullptr;  ///< null: nothing is wrong
  const char* must = nullptr;
};

/// The fault of the sector in a file that openContainer accepted. A file without a sector is faulty.
Fault sectorFaultOf(const File& file);

/// The fault of the level's index in such a file. A file without a level is faulty.
Fault levelFaultOf(const File& file);

/// Number of probes of a checked sector.
inline std::uint32_t probesOf(const Sector& sector) {
  return sector.probes()->sky_scale() == nullptr ? 0 : sector.probes()->sky_scale()->size();
}

}  // namespace welkin::format
