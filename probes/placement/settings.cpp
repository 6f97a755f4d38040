// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sky/base/error.h"

namespace welkin::placement {
namespace {

void checkLength(const char* key, double value, double least) {
  if (std::isfinite(value) && value >= least) return;
  throw base::Error(base::ExitStatus::content,
                    fmt::format("[probes] {} = {}: must be a length of {} m or more", key, value, least));
}

void checkBoxes(const char* what, const std::vector<geometry::Box>& boxes) {
  for (const geometry::Box& b : boxes)
    for (int axis = 0; axis < 3; ++axis)
      if (!std::isfinite(b.low[axis]) || !std::isfinite(b.high[axis]) || !(b.low[axis] < b.high[axis]))
        throw base::Error(
            base::ExitStatus::content,
            fmt::format("{}: [{}, {}, {}] to [{}, {}, {}]: the first corner must be below the second on each axis",
                        what, b.low.x, b.low.y, b.low.z, b.high.x, b.high.y, b.high.z));
}

}  // namespace

void checkSettings(const PlacementSettings& s) {
  checkLength("spacing_m", s.spacing_m, 0.25);
  checkLength("vegetation_spacing_m", s.vegetation_spacing_m, 0.25);
  checkLength("minimum_separation_m", s.minimum_separation_m, 0.0);
  checkLength("height_m", s.height_m, 0.01);
  checkLength("headroom_m", s.headroom_m, 0.01);
  checkLength("clearance_m", s.clearance_m, 0.001);
  checkLength("coverage_m", s.coverage_m, 0.25);
  for (const Number3& p : s.add)
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z) || std::abs(p.x) > 1e6 || std::abs(p.z) > 1e6)
      throw base::Error(base::ExitStatus::content,
                        fmt::format("[probes] add: [{}, {}, {}] must be within 1000 km of the origin", p.x, p.y, p.z));
  checkBoxes("[probes] remove", s.remove);
  checkBoxes("[[room]]", s.room);
  for (const RoomDoor& d : s.door) {
    checkBoxes("[[room]] doors", {d.box});
    if (!isDoorOf(d.box, d.room))
      throw base::Error(base::ExitStatus::content,
                        fmt::format("[[room]] doors: [{}, {}, {}] to [{}, {}, {}]: must cross one face of the room",
                                    d.box.low.x, d.box.low.y, d.box.low.z, d.box.high.x, d.box.high.y, d.box.high.z));
  }
}

PlacementSettings spreadBy(double factor, const PlacementSettings& settings) {
  constexpr double kLeast_m = 0.25;
  PlacementSettings spread = settings;
  spread.minimum_separation_m *= factor;
  spread.coverage_m = std::max(spread.coverage_m * factor, kLeast_m);
  for (double* distance_m : {&spread.spacing_m, &spread.vegetation_spacing_m})
    *distance_m = std::max(*distance_m * std::min(factor, 1.0), kLeast_m);
  return spread;
}

format::DoorBox doorBoxOf(const geometry::Box& door, const geometry::Box& room) {
  const auto numbers = [](const Number3& v) { return format::InWorld{v.x, v.y, v.z}; };
  return {numbers(door.low), numbers(door.high), numbers(room.low), numbers(room.high)};
}

bool isDoorOf(const geometry::Box& door, const geometry::Box& room) {
  const format::DoorWay way = format::doorWayOf(doorBoxOf(door, room));
  return way.is_door && way.face - way.low[way.axis] >= kLeastDoor_m && way.high[way.axis] - way.face >= kLeastDoor_m;
}

std::size_t roomOf(const PlacementSettings& settings, const Number3& position) {
  for (std::size_t i = 0; i < settings.room.size(); ++i)
    if (geometry::contains(settings.room[i], position)) return i + 1;
  return 0;
}

}  // namespace welkin::placement
