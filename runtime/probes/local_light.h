// SPDX-License-Identifier: Apache-2.0
// Light that virtual lights send to the probes of a sector, by its local transfer.
#pragma once

#include <welkin/level.h>

#include <cstdint>

#include "core/host_memory.h"

namespace welkin::probes {

/// The transfers of a sector in the order of their lights, so that one light reads its own alone.
struct LocalTransfers {
  core::HostArray<std::uint16_t> start;     ///< light: its first transfer; one more number ends the last
  core::HostArray<std::uint8_t> probe;      ///< transfer: its probe
  core::HostArray<std::uint16_t> transfer;  ///< transfer: its place in the file
  std::uint32_t count = 0;
};

/// Memory for a sector with virtual lights: the transfers, and `fixed` where emission has not made it. False when there
/// is none.
bool openTransfers(WelkinSector& sector);

/// Bytes of a sector's virtual lights and transfers.
std::size_t localBytes(const WelkinSector& sector);

/// Computes `fixed` of a sector from its emission and the colours of its virtual lights, and has the sector relit.
void lightLocally(WelkinSector& sector);

}  // namespace welkin::probes
