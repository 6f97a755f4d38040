// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/vegetation_boxes.h"

#include <algorithm>
#include <optional>

#include "probes/placement/lattice.h"

namespace welkin::placement {
namespace {

bool over(const geometry::Box& box, double x, double z) {
  return x >= box.low.x && x <= box.high.x && z >= box.low.z && z <= box.high.z;
}

std::optional<double> highestAt(const std::vector<geometry::Box>& boxes, double x, double z) {
  std::optional<double> result;
  for (const geometry::Box& box : boxes)
    if (over(box, x, z)) result = result ? std::max(*result, box.high.y) : box.high.y;
  return result;
}

/// Sectors along an axis with a line of the lattice within low to high.
std::vector<int> sectorsAlong(double low, double high, double spacing_m, double aside_m) {
  std::vector<int> result;
  const auto sectorOf = [](double v) { return static_cast<int>(std::floor(v / geometry::kSector_m)); };
  for (int sector = sectorOf(low); sector <= sectorOf(high); ++sector)
    if (!linesWithin(sector, low, high, spacing_m, aside_m).none()) result.push_back(sector);
  return result;
}

/// The sectors with lines that meet a box.
struct SectorsOfLines {
  std::vector<int> x, z;
  bool none() const { return x.empty() || z.empty(); }
};

SectorsOfLines sectorsOfLines(const geometry::Box& box, double spacing_m) {
  return {sectorsAlong(box.low.x, box.high.x, spacing_m, kLattice_x_m),
          sectorsAlong(box.low.z, box.high.z, spacing_m, kLattice_z_m)};
}

Number3 middleOf(const geometry::Box& box) {
  return (box.low + box.high) * 0.5;
}

}  // namespace

std::vector<geometry::Box> vegetationBoxes(const geometry::Surfaces& s) {
  std::vector<std::optional<geometry::Box>> box(s.object.size());
  for (const geometry::Triangle& t : s.triangle) {
    if (s.object[t.object].role != geometry::Role::vegetation) continue;
    for (const std::uint32_t v : t.vertex) {
      const Number3 p{double{s.position[v][0]}, double{s.position[v][1]}, double{s.position[v][2]}};
      std::optional<geometry::Box>& b = box[t.object];
      if (!b) b = geometry::Box{p, p};
      for (int axis = 0; axis < 3; ++axis) {
        b->low[axis] = std::min(b->low[axis], p[axis]);
        b->high[axis] = std::max(b->high[axis], p[axis]);
      }
    }
  }
  std::vector<geometry::Box> result;
  for (const auto& b : box)
    if (b) result.push_back(*b);
  return result;
}

std::vector<Number3> aboveVegetation(const std::vector<geometry::Box>& boxes, const PlacementSettings& settings,
                                     const geometry::SectorId& id) {
  std::vector<Number3> result;
  for (const LatticeLine& line : latticeOf(id, settings.vegetation_spacing_m))
    if (const auto high = highestAt(boxes, line.x, line.z))
      result.push_back({line.x, *high + settings.height_m, line.z});
  for (const geometry::Box& box : boxes) {
    const Number3 middle = middleOf(box);
    if (geometry::sectorAt(middle) != id || !sectorsOfLines(box, settings.vegetation_spacing_m).none()) continue;
    const double high = highestAt(boxes, middle.x, middle.z).value_or(box.high.y);
    result.push_back({middle.x, high + settings.height_m, middle.z});
  }
  return result;
}

std::vector<geometry::SectorId> sectorsOfVegetation(const geometry::Box& box, const PlacementSettings& settings) {
  const SectorsOfLines along = sectorsOfLines(box, settings.vegetation_spacing_m);
  if (along.none()) return {geometry::sectorAt(middleOf(box))};
  std::vector<geometry::SectorId> result;
  for (const int x : along.x)
    for (const int z : along.z) result.push_back({x, z});
  return result;
}

}  // namespace welkin::placement
