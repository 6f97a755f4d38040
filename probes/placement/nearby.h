// SPDX-License-Identifier: Apache-2.0
// Finds points of a sector in order of distance.
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "probes/geometry/sector.h"
#include "probes/placement/validity.h"

namespace welkin::placement {

using f64::Number3;

/// Numbered points in patches of 1 m.
class Nearby {
 public:
  explicit Nearby(const geometry::SectorId& id)
      : low_x_(geometry::kSector_m * id.x), low_z_(geometry::kSector_m * id.z) {}

  /// Adds a point. The position must be within the sector.
  void add(std::size_t number, const Number3& position) {
    patch_[indexOf(patchAt(position.x - low_x_), patchAt(position.z - low_z_))].push_back({number, position});
  }

  /// Calls visit(number, distance) until it returns false, for points nearer than `far_m` for which counts(number)
  /// holds. Points come in order of distance, then of number.
  template <typename Counts, typename Visit>
  void visit(const Number3& from, double far_m, const Counts& counts, const Visit& visit) const {
    std::vector<std::pair<double, std::size_t>> found;
    for (double inner_m = 0.0, outer_m = 1.0; inner_m < far_m; inner_m = outer_m, outer_m *= 2.0) {
      const double end_m = std::min(outer_m, far_m);
      found.clear();
      const int last_k = patchAt(from.z - low_z_ + end_m);
      const int last_i = patchAt(from.x - low_x_ + end_m);
      for (int k = patchAt(from.z - low_z_ - end_m); k <= last_k; ++k)
        for (int i = patchAt(from.x - low_x_ - end_m); i <= last_i; ++i)
          for (const auto& [number, position] : patch_[indexOf(i, k)]) {
            if (!counts(number)) continue;
            const double distance_m = distanceOf(from, position);
            if (distance_m >= inner_m && distance_m < end_m) found.emplace_back(distance_m, number);
          }
      std::sort(found.begin(), found.end());
      for (const auto& [distance_m, number] : found)
        if (!visit(number, distance_m)) return;
    }
  }

 private:
  static constexpr int kAcross = static_cast<int>(geometry::kSector_m);

  static int patchAt(double offset_m) { return static_cast<int>(std::floor(std::clamp(offset_m, 0.0, kAcross - 1.0))); }
  static std::size_t indexOf(int i, int k) { return static_cast<std::size_t>(i + kAcross * k); }

  double low_x_, low_z_;
  std::array<std::vector<std::pair<std::size_t, Number3>>, std::size_t{kAcross} * kAcross> patch_;
};

}  // namespace welkin::placement
