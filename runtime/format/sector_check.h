// SPDX-License-Identifier: Apache-2.0
// What the file of a sector and the index of a level must hold before anything reads them: every field there, every
// length as the others ask, every number in its domain, every index inside. Nothing is allocated and nothing thrown.
#pragma once

#include "welkin_generated.h"

namespace welkin::format {

inline constexpr std::uint32_t kGridCells = 4096;           ///< of a sector
inline constexpr std::uint32_t kMostProbes = 255;           ///< of a sector
inline constexpr std::uint8_t kNoProbe = 255;               ///< of a cell
inline constexpr std::uint32_t kTopCells = 256;             ///< of a sector
inline constexpr std::uint32_t kMostRooms = 254;            ///< of a sector
inline constexpr std::uint32_t kMostNamedPlaces = 32;       ///< of a sector
inline constexpr std::uint32_t kMostSunModes = 16;          ///< of a sector
inline constexpr std::uint32_t kMostLocalLights = 128;      ///< of a probe
inline constexpr std::uint32_t kMostVirtualLights = 65536;  ///< of a sector
inline constexpr std::int32_t kFarthestSector = 15625;

/// What is wrong, and what it must be: "the grid", "must have 4096 cells".
struct Fault {
  const char* what = nullptr;  ///< null: nothing is wrong
  const char* must = nullptr;
};

/// The sector of a file that openContainer took. A file without one is faulty.
Fault sectorFaultOf(const File& file);

/// The level of such a file.
Fault levelFaultOf(const File& file);

/// Probes of a checked sector.
inline std::uint32_t probesOf(const Sector& sector) {
  return sector.probes()->sky_scale() == nullptr ? 0 : sector.probes()->sky_scale()->size();
}

}  // namespace welkin::format
