// SPDX-License-Identifier: Apache-2.0
#include "format/doors.h"

#include <algorithm>

#include "shared.h"

#define INLINE inline
#define NUMBER(literal) Number(literal)
namespace welkin::format {
namespace door_formulas {
using namespace f64;
#include "doors.glsl"  // NOLINT(bugprone-suspicious-include)
}  // namespace door_formulas
#undef NUMBER
#undef INLINE

namespace {

/// Looks for a face of the room along an axis that the door crosses. Returns how many it crosses.
int crossing(const DoorBox& box, std::size_t axis, DoorWay& way) {
  int count = 0;
  for (const bool rises : {false, true}) {
    const double face = rises ? box.room_high[axis] : box.room_low[axis];
    if (!(box.low[axis] < face && face < box.high[axis])) continue;
    ++count;
    way.axis = axis;
    way.rises = rises;
    way.face = face;
  }
  return count;
}

}  // namespace

DoorWay doorWayOf(const DoorBox& box) {
  constexpr double kFadingShare = 0.25;  // of the width, on each side
  DoorWay way;
  int count = crossing(box, 0, way) + crossing(box, 2, way);
  if (count == 0) count = crossing(box, 1, way);
  if (count != 1) return way;
  for (std::size_t a = 0; a < 3; ++a) {
    const bool is_across = a == way.axis;
    way.low[a] = is_across ? box.low[a] : std::max(box.low[a], box.room_low[a]);
    way.high[a] = is_across ? box.high[a] : std::min(box.high[a], box.room_high[a]);
    if (!(way.high[a] - way.low[a] >= kThinnestDoor_m)) return way;
    const double width = kFadingShare * (way.high[a] - way.low[a]);
    const bool fades = a != 1 && !is_across;
    way.width[a] = width;
    way.fade_low[a] = fades && box.low[a] > box.room_low[a] ? way.low[a] : way.low[a] - width;
    way.fade_high[a] = fades && box.high[a] < box.room_high[a] ? way.high[a] : way.high[a] + width;
  }
  way.is_door = true;
  return way;
}

BeyondDoor beyondDoor(const DoorWay& way, const InWorld& place) {
  BeyondDoor beyond;
  for (std::size_t a = 0; a < 3; ++a)
    if (!(place[a] >= way.low[a] && place[a] <= way.high[a])) return beyond;
  const std::size_t axis = way.axis;
  const double inner = way.rises ? way.low[axis] : way.high[axis], outer = way.rises ? way.high[axis] : way.low[axis];
  beyond.share = door_formulas::doorThrough(place[axis], way.face, inner, outer);
  for (const std::size_t a : {std::size_t{0}, std::size_t{2}})
    beyond.share *= door_formulas::doorFade(place[a], way.fade_low[a], way.fade_high[a], way.width[a]);
  beyond.place = place;
  const bool is_outside = way.rises ? place[axis] > way.face : place[axis] < way.face;
  beyond.place[axis] = way.face + (is_outside == way.rises ? -kBeyondFace_m : kBeyondFace_m);
  return beyond;
}

}  // namespace welkin::format
