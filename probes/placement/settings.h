// SPDX-License-Identifier: Apache-2.0
// What placement is told ([probes] and [[room]] of level.toml) and what it reports.
#pragma once

#include <vector>

#include "probes/geometry/sector.h"

namespace welkin::placement {

using f64::Number3;

/// Lengths in metres, all > 0.
struct PlacementSettings {
  double spacing_m = 4.0;             ///< of the lattice of vertical rays over static geometry
  double vegetation_spacing_m = 8.0;  ///< of that over the boxes of vegetation
  double minimum_separation_m = 7.0;  ///< of two probes of a sector that see each other
  double height_m = 1.0;              ///< above the surface; half of the free height where that is less
  double headroom_m = 1.2;            ///< free height above a surface that counts as ground
  double clearance_m = 0.2;           ///< between a probe and the nearest surface
  double coverage_m = 8.0;            ///< every walkable point sees a probe that is as near as this
  std::vector<Number3> add;           ///< probes by hand
  std::vector<geometry::Box> remove;  ///< no probe in there, but for those by hand
  std::vector<geometry::Box> room;    ///< inside and outside have probes of their own
};

/// Throws Error(content) with key, value and range for a setting out of its range.
void checkSettings(const PlacementSettings& settings);

/// The room of a position, counted from 1 in the order of the settings; 0 outside of all.
std::size_t roomOf(const PlacementSettings& settings, const Number3& position);

/// A probe that was moved, and whether it was one by hand.
struct MovedProbe {
  Number3 from;
  Number3 to;
  bool by_hand = false;
};

/// A place that got no probe.
struct DroppedProbe {
  enum class Reason {
    inside,     ///< of geometry, and no free place near by; such ground is not walked on
    too_close,  ///< to a surface, and no free place near by
    thinned,    ///< the sector has more than kMostProbes; this one was the least loss
  };
  Number3 position;
  Reason reason = Reason::inside;
  bool by_hand = false;
};

/// What placing did in a sector. Nothing that it left out is missing here.
struct PlacementReport {
  std::size_t columns = 0;          ///< of the lattice
  std::size_t ground = 0;           ///< surfaces on it that one can stand on
  std::size_t buried = 0;           ///< surfaces inside of closed geometry
  std::size_t low = 0;              ///< surfaces without the headroom
  std::size_t under_water = 0;      ///< surfaces with water above: no ground
  std::size_t walkable = 0;         ///< points on ground to 60 degrees, of the lattice and of one twice as fine
  std::size_t removed = 0;          ///< candidates within boxes of `remove`
  std::size_t near_others = 0;      ///< candidates left out for the minimum separation
  std::size_t added_for_sight = 0;  ///< probes that walkable points needed nevertheless
  std::vector<MovedProbe> moved;    ///< out of geometry or away from it
  std::vector<DroppedProbe> dropped;
  std::vector<Number3> uncovered;        ///< walkable points that see no probe within coverage_m
  std::size_t cells_by_middle = 0;       ///< of the grid: whose middle sees its probe
  std::size_t cells_by_part = 0;         ///< another free point of the cell sees it
  std::size_t cells_by_way = 0;          ///< round a corner: free points of neighbouring cells see each other
  std::size_t cells_inside = 0;          ///< all geometry: named for the filter, seen by all the free cells about it
  std::size_t cells_without = 0;         ///< no probe, free or not
  std::size_t ground_cells_without = 0;  ///< of those, cells with air above ground
};

}  // namespace welkin::placement
