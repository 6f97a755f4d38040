// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "probes/placement/ground_part.h"
#include "probes/placement/lattice.h"
#include "probes/placement/placement.h"
#include "probes/placement/vegetation_boxes.h"
#include "sky/base/error.h"

namespace welkin::placement {

using f64::Number3;
namespace {

/// A triangle seen from above, metres. It contains lines on its edge; placeSector checks with a ray.
class Shadow {
 public:
  explicit Shadow(const std::array<Number3, 3>& corner) : corner_(corner) {
    const Number3 ab = corner[1] - corner[0];
    const Number3 ac = corner[2] - corner[0];
    area_ = ab.z * ac.x - ab.x * ac.z;
  }

  /// Whether its front looks up or, with two sides, whether either side does.
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
  double area_;  // twice the area, positive if the triangle looks up
};

bool meetsALine(const Shadow& shadow, const geometry::SectorId& id, double spacing_m) {
  const auto lines = [&](int axis, int sector, double aside_m) {
    constexpr double kEdge_m = 1e-3;
    return linesWithin(sector, shadow.low(axis) - kEdge_m, shadow.high(axis) + kEdge_m, spacing_m, aside_m);
  };
  const LineRange along_x = lines(0, id.x, kLattice_x_m);
  const LineRange along_z = lines(2, id.z, kLattice_z_m);
  for (int k = along_z.first; k <= along_z.last; ++k)
    for (int i = along_x.first; i <= along_x.last; ++i)
      if (shadow.covers(lineAt(id.x, i, spacing_m, kLattice_x_m), lineAt(id.z, k, spacing_m, kLattice_z_m)))
        return true;
  return false;
}

/// The sectors found so far. Throws if they, or those under one object, are too many.
class SectorSet {
 public:
  const std::set<geometry::SectorId>& sectors() const { return sectors_; }
  bool contains(const geometry::SectorId& id) const { return sectors_.contains(id); }

  template <typename Name>
  void checkSpan(const geometry::SectorId& low, const geometry::SectorId& high, const Name& name) const {
    check((high.x - low.x + 1.0) * (high.z - low.z + 1.0), "spans", name);
  }

  template <typename Name>
  void add(const geometry::SectorId& id, const Name& name) {
    sectors_.insert(id);
    check(static_cast<double>(sectors_.size()), "makes the level one of", name);
  }

 private:
  template <typename Name>
  static void check(double count, const char* how, const Name& name) {
    if (count > static_cast<double>(kMostSectors))
      throw base::Error(base::ExitStatus::content, fmt::format("{} {} {:.0f} sectors of 64 m; at most {} may be",
                                                               name(), how, count, kMostSectors));
  }

  std::set<geometry::SectorId> sectors_;
};

/// The sectors that get probes: those that one of the boxes touches, seen from above; without boxes all.
class Allowed {
 public:
  explicit Allowed(const std::vector<geometry::Box>& boxes) {
    for (const geometry::Box& b : boxes) {
      squares_.push_back({geometry::sectorAt(b.low), geometry::sectorAt(b.high)});
      low_ = {std::min(low_.x, squares_.back().low.x), std::min(low_.z, squares_.back().low.z)};
      high_ = {std::max(high_.x, squares_.back().high.x), std::max(high_.z, squares_.back().high.z)};
    }
  }

  bool holds(geometry::SectorId id) const {
    return squares_.empty() || std::any_of(squares_.begin(), squares_.end(), [&](const Square& s) {
             return id.x >= s.low.x && id.x <= s.high.x && id.z >= s.low.z && id.z <= s.high.z;
           });
  }

  /// Narrows a span to one that has all allowed sectors of it.
  void narrow(geometry::SectorId& low, geometry::SectorId& high) const {
    if (squares_.empty()) return;
    low = {std::max(low.x, low_.x), std::max(low.z, low_.z)};
    high = {std::min(high.x, high_.x), std::min(high.z, high_.z)};
  }

 private:
  struct Square {
    geometry::SectorId low, high;
  };
  static constexpr int kMost = std::numeric_limits<int>::max();
  std::vector<Square> squares_;
  geometry::SectorId low_{kMost, kMost}, high_{-kMost, -kMost};
};

}  // namespace

std::vector<geometry::SectorId> sectorsOf(const geometry::Surfaces& s, const PlacementSettings& settings,
                                          const base::Progress& progress) {
  checkSettings(settings);
  const Allowed allowed(settings.within);
  SectorSet found;
  std::map<geometry::SectorId, double> between_m2;  // walkable ground of sectors that no line meets
  for (const geometry::Triangle& t : s.triangle) {
    if (s.object[t.object].role != geometry::Role::fixed) continue;
    const std::array<Number3, 3> corner = cornersOf(s, t);
    const Shadow shadow(corner);
    const bool two_sides = s.material[t.material].double_sided;
    if (!shadow.ground(two_sides)) continue;
    const bool walkable = isWalkable(corner, two_sides);
    geometry::SectorId low = geometry::sectorAt({shadow.low(0), 0, shadow.low(2)});
    geometry::SectorId high = geometry::sectorAt({shadow.high(0), 0, shadow.high(2)});
    allowed.narrow(low, high);
    if (low.x > high.x || low.z > high.z) continue;
    const auto name = [&] { return fmt::format("object \"{}\"", s.object[t.object].name); };
    found.checkSpan(low, high, name);
    for (int x = low.x; x <= high.x; ++x) {
      progress.check();
      for (int z = low.z; z <= high.z; ++z) {
        const geometry::SectorId id{x, z};
        if (found.contains(id) || !allowed.holds(id)) continue;
        if (meetsALine(shadow, id, settings.spacing_m))
          found.add(id, name);
        else if (walkable)
          between_m2[id] += partOver(corner, id).area_m2;
      }
    }
  }
  const auto others = [] { return "all the level's ground, vegetation and probes by hand"; };
  for (const auto& [id, area_m2] : between_m2)
    if (area_m2 >= kLeastGround_m2) found.add(id, others);
  for (const geometry::Box& box : vegetationBoxes(s)) {
    geometry::SectorId low = geometry::sectorAt(box.low);
    geometry::SectorId high = geometry::sectorAt(box.high);
    allowed.narrow(low, high);
    if (low.x > high.x || low.z > high.z) continue;
    found.checkSpan(low, high, [&] {
      return fmt::format("vegetation from ({}, {}) to ({}, {}) m", box.low.x, box.low.z, box.high.x, box.high.z);
    });
    progress.check();
    for (const geometry::SectorId& id : sectorsOfVegetation(box, settings))
      if (allowed.holds(id)) found.add(id, others);
  }
  for (const Number3& p : settings.add) found.add(geometry::sectorAt(p), others);
  return {found.sectors().begin(), found.sectors().end()};
}

}  // namespace welkin::placement
