// SPDX-License-Identifier: Apache-2.0
// Settings of placement ([probes] and [[room]] of level.toml) and its report.
#pragma once

#include <cstdint>
#include <vector>

#include "format/doors.h"
#include "probes/geometry/sector.h"

namespace welkin::placement {

using f64::Number3;

/// What a bake does about walls that part a cell, or cells beside each other.
enum class Walls : std::uint8_t {
  cut,     ///< cells are cut along them, so that no light is filtered through
  ignore,  ///< nothing, as Far Cry 3 did: thin walls leak, except those of rooms
};

/// A soft part of a room's face.
struct RoomDoor {
  geometry::Box room, box;
};

/// Lengths in metres, all > 0.
struct PlacementSettings {
  double spacing_m = 4.0;             ///< spacing of vertical rays over static geometry
  double vegetation_spacing_m = 8.0;  ///< spacing of vertical rays over the boxes of vegetation
  double minimum_separation_m = 7.0;  ///< between two probes of a sector that see each other
  double height_m = 1.0;              ///< height above the surface; half of the free height if that is less
  double headroom_m = 1.2;            ///< free height above a surface that counts as ground
  double clearance_m = 0.2;           ///< between a probe and the nearest surface
  double coverage_m = 8.0;            ///< every walkable point sees a probe within this distance
  Walls walls = Walls::cut;
  std::vector<Number3> add;           ///< probes by hand
  std::vector<geometry::Box> remove;  ///< no probes inside, except those by hand
  std::vector<geometry::Box> within;  ///< only sectors that they touch, seen from above, have probes; none: all
  std::vector<geometry::Box> room;    ///< boxes with separate probes inside and outside
  std::vector<RoomDoor> door;         ///< of these rooms
};

/// Throws Error(content) with key, value and range for a setting out of its range.
void checkSettings(const PlacementSettings& settings);

/// The settings with the distances between probes times `factor` > 0. The lattices become no wider, so that no
/// ground is missed, and none closer than settings allow.
PlacementSettings spreadBy(double factor, const PlacementSettings& settings);

inline constexpr double kLeastDoor_m = 0.05;  ///< a door reaches so far to each side of its face

/// Whether a box may be a door of a room: it crosses one face (format::doorWayOf) and reaches kLeastDoor_m to each
/// side.
bool isDoorOf(const geometry::Box& door, const geometry::Box& room);

/// A door and its room as the runtime takes them (format/doors.h).
format::DoorBox doorBoxOf(const geometry::Box& door, const geometry::Box& room);

/// The room of a position, counted from 1 in the order of the settings; 0 outside of all.
std::size_t roomOf(const PlacementSettings& settings, const Number3& position);

/// A probe that was moved.
struct MovedProbe {
  Number3 from;
  Number3 to;
  bool by_hand = false;
};

/// A place that got no probe.
struct DroppedProbe {
  enum class Reason {
    inside,     ///< inside geometry, and no free place is near; such ground is not walkable
    too_close,  ///< too close to a surface, and no free place is near
    thinned,    ///< the sector had more than kMostProbes, and this one was the smallest loss
  };
  Number3 position;
  Reason reason = Reason::inside;
  bool by_hand = false;
};

/// Report of placing a sector. It lists everything that was left out.
struct PlacementReport {
  std::size_t columns = 0;          ///< lines of the lattice
  std::size_t ground = 0;           ///< surfaces on the lattice that one can stand on
  std::size_t buried = 0;           ///< surfaces inside closed geometry
  std::size_t low = 0;              ///< surfaces without enough headroom
  std::size_t under_water = 0;      ///< surfaces with water above, which are no ground
  std::size_t walkable = 0;         ///< points on ground up to 60 degrees, of the lattice and of one twice as fine
  std::size_t removed = 0;          ///< candidates inside boxes of `remove`
  std::size_t near_others = 0;      ///< candidates dropped for the minimum separation
  std::size_t added_for_sight = 0;  ///< probes added because walkable points needed them
  std::vector<MovedProbe> moved;    ///< probes moved out of geometry or away from it
  std::vector<DroppedProbe> dropped;
  std::vector<Number3> uncovered;   ///< walkable points that see no probe within coverage_m
  std::size_t cells_by_middle = 0;  ///< cells of the grid whose middle sees the probe
  std::size_t cells_by_part = 0;    ///< cells where another free point sees the probe
  std::size_t cells_by_way = 0;     ///< cells round a corner: points of neighbouring cells see each other
  std::size_t cells_inside = 0;     ///< cells full of geometry; for the filter, a probe that all free cells around see
  std::size_t cells_without = 0;    ///< cells without a probe, free or not
  std::size_t ground_cells_without = 0;  ///< cells without a probe but with air above ground
};

}  // namespace welkin::placement
