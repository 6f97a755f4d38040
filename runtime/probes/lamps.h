// SPDX-License-Identifier: Apache-2.0
// The dynamic lights of a level, and the colours that virtual lights have from them.
#pragma once

#include "probes/light_shares.h"

namespace welkin::probes {

inline constexpr std::uint32_t kDefaultLamps = 256;
inline constexpr std::uint32_t kMostLamps = 65536;

struct Lamps {
  core::HostArray<Lamp> lamp;
  std::uint32_t capacity = 0;
  std::uint32_t count = 0;
  WelkinSees sees = nullptr;  ///< of the last call
};

/// Memory for lamps. False when there is none.
bool openLamps(const core::HostMemory& memory, std::uint32_t capacity, Lamps& lamps);

/// Joins a sector that became resident to the virtual lights, or takes one away that is about to leave. Lamps that this
/// may concern become stale.
void lightsCome(WelkinLevel& level, WelkinSector& sector);
void lightsLeave(WelkinLevel& level, WelkinSector& sector);

}  // namespace welkin::probes
