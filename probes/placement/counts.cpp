// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/counts.h"

#include <cmath>
#include <tuple>

#include "probes/placement/validity.h"

namespace welkin::placement {
namespace {

using Kind = NamedPlace::Kind;

/// Collects the places of one kind after the other.
class Naming {
 public:
  void begin() { of_kind_ = 0; }

  void add(const NamedPlace& place) {
    const bool first = place.kind != Kind::moved && of_kind_ < kMostNamed;
    if (place.kind != Kind::moved) ++of_kind_;
    if (!first && !(place.by_hand && by_hand_ < kMostNamedByHand)) return;
    if (place.by_hand) ++by_hand_;
    named_.push_back(place);
  }

  std::vector<NamedPlace> take() { return std::move(named_); }

 private:
  std::size_t of_kind_ = 0;
  std::size_t by_hand_ = 0;
  std::vector<NamedPlace> named_;
};

}  // namespace

Number3 placeInWorld(geometry::SectorId sector, const NamedPlace& place) {
  const Number3 p = place.position + geometry::cornerOf(sector);
  const auto rounded = [](double v) { return std::round(v * 1e6) / 1e6; };
  return {rounded(p.x), p.y, rounded(p.z)};
}

PlacementCounts countsOf(const PlacementReport& r) {
  PlacementCounts c;
  c.columns = r.columns;
  c.ground = r.ground;
  c.walkable = r.walkable;
  c.moved = r.moved.size();
  c.uncovered = r.uncovered.size();
  c.cells_without = r.cells_without;
  Naming naming;
  using Reason = DroppedProbe::Reason;
  for (const auto& [reason, kind, count] : {std::tuple(Reason::inside, Kind::inside, &c.inside),
                                            std::tuple(Reason::too_close, Kind::too_close, &c.too_close),
                                            std::tuple(Reason::thinned, Kind::thinned, &c.thinned)}) {
    naming.begin();
    for (const DroppedProbe& d : r.dropped) {
      if (d.reason != reason) continue;
      ++*count;
      c.by_hand_dropped += d.by_hand ? 1 : 0;
      naming.add({d.position, 0.0, kind, d.by_hand});
    }
  }
  naming.begin();
  for (const Number3& p : r.uncovered) naming.add({p, 0.0, Kind::uncovered, false});
  for (const MovedProbe& m : r.moved) {
    c.by_hand_moved += m.by_hand ? 1 : 0;
    naming.add({m.from, distanceOf(m.from, m.to), Kind::moved, m.by_hand});
  }
  c.named = naming.take();
  return c;
}

}  // namespace welkin::placement
