// SPDX-License-Identifier: Apache-2.0
// The checks of a sector's parts, for sector_check.h. Each adds to a Check.
#pragma once

#include <span>

#include "format/sector_check.h"

namespace welkin::format {

/// Keeps the first complaint.
struct Check {
  Fault fault;

  bool that(bool holds, const char* what, const char* must) {
    if (!holds && fault.what == nullptr) fault = {what, must};
    return fault.what == nullptr;
  }
};

inline constexpr double kFarthest_m = 1e7;

void checkProbes(Check& check, const Probes& probes, SunTransfer sun);
void checkError(Check& check, const SectorError& error, std::size_t probes);
void checkLocal(Check& check, const LocalTransfer& local, std::size_t probes);
void checkRooms(Check& check, const Sector& sector, std::size_t probes);
/// The doors of a sector that has some, after its rooms.
void checkDoors(Check& check, const Sector& sector);
void checkPlacement(Check& check, const Placement& placement);
/// Every cell, tree, plane, mask and probe of the cuts is there, and every tree is whole and of at most kMostTreeNodes.
void checkCuts(Check& check, const Cuts& cuts, std::size_t probes);

/// Whether each scale is the upper half of a float32 in [0, kAny].
bool areScales(std::span<const std::uint16_t> scales);

/// Whether a sector's numbers are in their range.
bool isPlace(std::int32_t x, std::int32_t z);

}  // namespace welkin::format
