// SPDX-License-Identifier: Apache-2.0
// The boxes whose insides their own probes light alone.
#pragma once

#include "format/doors.h"
#include "probes/look_up.h"

namespace welkin::probes {

/// A box of a room in the world, metres.
struct RoomBox {
  format::InWorld low, high;
};

/// Room `number`, from 1, of a sector.
RoomBox roomBox(const WelkinSector& sector, std::uint32_t number);

/// Rooms of a sector, those of its neighbours that reach into it too.
inline std::uint32_t roomsOf(const WelkinSector& sector) {
  return sector.file->room() == nullptr ? 0 : sector.file->room()->size();
}

/// 1 + the first of the sector's rooms that contains a point, or 0.
std::uint32_t roomAt(const WelkinSector& sector, const format::InWorld& p);

/// The place beyond the face of a door of the sector from which a place has some of its light, and the share.
format::BeyondDoor beyondDoorOf(const WelkinSector& sector, const format::InWorld& p);

/// Whether a probe is in room `number` of the sector `home`, or outside all rooms if that is 0.
bool isInRoom(const WelkinSector& sector, std::uint8_t probe, const WelkinSector& home, std::uint32_t number);

/// The room's own probe, for a point in room `number` that no other serves. Nothing if that is 0 or the room has none.
void serveFromRoom(const WelkinSector& home, std::uint32_t number, PointProbes& out);

}  // namespace welkin::probes
