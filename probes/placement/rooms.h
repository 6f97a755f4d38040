// SPDX-License-Identifier: Apache-2.0
// Rooms are boxes with probes of their own inside (the interior volumes of Gilabert and Stefanov, "Deferred Radiance
// Transfer Volumes", GDC 2012).
#pragma once

#include "probes/placement/settings.h"

namespace welkin::placement {

/// Fills `room` and `in_room` of a sector whose probes are placed. Throws Error(content) if more than kMostRooms touch
/// it.
void setRooms(const PlacementSettings& settings, geometry::PlacedSector& sector);

}  // namespace welkin::placement
