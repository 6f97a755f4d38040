// SPDX-License-Identifier: Apache-2.0
// Rooms are boxes with probes of their own inside (the interior volumes of Gilabert and Stefanov, "Deferred Radiance
// Transfer Volumes", GDC 2012).
#pragma once

#include "probes/placement/settings.h"

namespace welkin::placement {

/// Fills `room`, `in_room` and `door` of a sector whose probes are placed. Throws Error(content) if more than
/// kMostRooms or kMostDoors touch it.
void setRooms(const PlacementSettings& settings, geometry::PlacedSector& sector);

}  // namespace welkin::placement
