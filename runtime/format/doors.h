// SPDX-License-Identifier: Apache-2.0
// Doors: boxes across a face of a room, in which the light of one side goes over smoothly into that of the other. A
// place in one has its own light and that of a place beyond the face, by shaders/shared/doors.glsl.
#pragma once

#include <array>
#include <cstddef>

#include "format/cut_lookup.h"
#include "welkin_generated.h"

namespace welkin::format {

inline constexpr std::size_t kMostDoors = 254;   ///< per sector
inline constexpr double kBeyondFace_m = 0x1p-8;  ///< a place beyond a face is at least this far from it

inline constexpr double kThinnestDoor_m = 1e-3;  ///< along each axis

/// Boxes of a door and of its room in one frame, metres.
struct DoorBox {
  InWorld low, high, room_low, room_high;
};

/// A door of a file and its room, from the sector's corner.
inline DoorBox boxOf(const Door& d, const Room& r) {
  return {{double{d.low_x()}, double{d.low_y()}, double{d.low_z()}},
          {double{d.high_x()}, double{d.high_y()}, double{d.high_z()}},
          {double{r.low_x()}, double{r.low_y()}, double{r.low_z()}},
          {double{r.high_x()}, double{r.high_y()}, double{r.high_z()}}};
}

/// The part of a door that is beside its room's box.
struct DoorWay {
  bool is_door = false;   ///< false: the box crosses no face, or several, or is thinner than kThinnestDoor_m
  std::size_t axis = 0;   ///< of the face's normal
  bool rises = false;     ///< whether the room is below the face
  double face = 0.0;      ///< along the axis
  InWorld low{}, high{};  ///< the door's box; along the other axes no wider than the room
  InWorld fade_low{}, fade_high{}, width{};  ///< x and z: where the door ends sideways, and over what length it fades
};

/// A place beyond the face of a door, and its share of the light. The share is 0 for a place in no door.
struct BeyondDoor {
  double share = 0.0;
  InWorld place{};
};

/// The way through a door. Its face is the one upright face that the box crosses, or without such, top or bottom.
DoorWay doorWayOf(const DoorBox& box);

/// Where a place in the way of a door has its other light from.
BeyondDoor beyondDoor(const DoorWay& way, const InWorld& place);

}  // namespace welkin::format
