// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>

#include "probes/placement/lattice.h"
#include "probes/placement/placement.h"
#include "probes/placement/vegetation_boxes.h"

namespace welkin::probes {
namespace {

/// A triangle from above, metres. A line on its edge counts: what a ray says there is for placeSector to see.
class Shadow {
 public:
  explicit Shadow(const std::array<Number3, 3>& corner) : corner_(corner) {
    const Number3 ab = corner[1] - corner[0];
    const Number3 ac = corner[2] - corner[0];
    area_ = ab.z * ac.x - ab.x * ac.z;
  }

  /// Whether its front looks up, and, of one with two sides, whether any does.
  bool ground(bool two_sides) const { return two_sides ? area_ != 0.0 : area_ > 0.0; }

  bool covers(double x, double z) const {
    constexpr double kEdge_m = 1e-3;
    for (std::size_t i = 0; i < 3; ++i) {
      const Number3& p = corner_[i];
      const Number3 edge = corner_[(i + 1) % 3] - p;
      const double side = (edge.z * (x - p.x) - edge.x * (z - p.z)) * (area_ < 0.0 ? -1.0 : 1.0);
      if (side < -kEdge_m * std::sqrt(edge.x * edge.x + edge.z * edge.z)) return false;
    }
    return true;
  }

  double low(int axis) const { return std::min({corner_[0][axis], corner_[1][axis], corner_[2][axis]}); }
  double high(int axis) const { return std::max({corner_[0][axis], corner_[1][axis], corner_[2][axis]}); }

 private:
  std::array<Number3, 3> corner_;
  double area_;  // twice, positive when it looks up
};

bool meetsALine(const Shadow& shadow, const SectorId& id, double spacing_m) {
  const auto lines = [&](int axis, int sector, double aside_m) {
    constexpr double kEdge_m = 1e-3;
    const double low = std::max(shadow.low(axis) - kEdge_m, kSector_m * sector);
    const double high = std::min(shadow.high(axis) + kEdge_m, kSector_m * (sector + 1.0));
    return std::pair{lineFrom(low, spacing_m, aside_m), lineFrom(high, spacing_m, aside_m)};
  };
  const auto [first_i, last_i] = lines(0, id.x, kLattice_x_m);
  const auto [first_k, last_k] = lines(2, id.z, kLattice_z_m);
  for (int k = first_k; k <= last_k; ++k)
    for (int i = first_i; i <= last_i; ++i) {
      const double x = lineAt(i, spacing_m, kLattice_x_m);
      const double z = lineAt(k, spacing_m, kLattice_z_m);
      if (sectorAt({x, 0, z}) == id && shadow.covers(x, z)) return true;
    }
  return false;
}

}  // namespace

std::vector<SectorId> sectorsOf(const Surfaces& s, const PlacementSettings& settings, const Checkpoint& checkpoint) {
  checkSettings(settings);
  std::set<SectorId> result;
  for (const Triangle& t : s.triangle) {
    if (s.object[t.object].role != Role::fixed) continue;
    std::array<Number3, 3> corner;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& p = s.position[t.vertex[i]];
      corner[i] = {double{p[0]}, double{p[1]}, double{p[2]}};
    }
    const Shadow shadow(corner);
    if (!shadow.ground(s.material[t.material].double_sided)) continue;
    const SectorId low = sectorAt({shadow.low(0), 0, shadow.low(2)});
    const SectorId high = sectorAt({shadow.high(0), 0, shadow.high(2)});
    for (int x = low.x; x <= high.x; ++x) {
      pass(checkpoint);
      for (int z = low.z; z <= high.z; ++z)
        if (!result.contains({x, z}) && meetsALine(shadow, {x, z}, settings.spacing_m)) result.insert({x, z});
    }
  }
  for (const SectorId& id : sectorsOfVegetation(vegetationBoxes(s), settings)) result.insert(id);
  for (const Number3& p : settings.add) result.insert(sectorAt(p));
  return {result.begin(), result.end()};
}

}  // namespace welkin::probes
