// SPDX-License-Identifier: Apache-2.0
// The runtime's look-up within one sector as a linear map: the weight of every probe at a point.
#pragma once

#include <cstdint>
#include <vector>

#include "format/cut_lookup.h"
#include "probes/fit/fit_points.h"
#include "probes/placement/sector_cuts.h"

namespace welkin::fit {

/// What a sector's own probes give to a point.
struct PointWeights {
  struct Entry {
    std::uint32_t probe;
    double weight;
  };
  std::vector<Entry> probe;  ///< of this sector, by index; the weights sum to 1
  double share = 0.0;        ///< of the whole look-up that falls to these probes, in (0, 1]; 0: none serves the point
};

class LookUp {
 public:
  /// A sector as if it were 0_0. Both must outlive the object.
  LookUp(const geometry::PlacedSector& sector, const placement::SectorCuts& cuts);

  /// As sectors::LevelLight looks up, if there were no sector but this one. Nothing for a point whose place is in
  /// another sector.
  PointWeights at(const FitPoint& point) const;

 private:
  PointWeights ofSide(const format::InWorld& place) const;
  std::size_t roomAt(const Number3& position) const;

  const geometry::PlacedSector& sector_;
  format::GridView grid_;
};

}  // namespace welkin::fit
