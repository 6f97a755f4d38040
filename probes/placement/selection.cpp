// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/selection.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "probes/placement/narrow_ground.h"
#include "probes/placement/nearby.h"
#include "probes/placement/thinning.h"
#include "probes/placement/validity.h"

namespace welkin::placement {

using f64::Number3;
namespace {

class Selection {
 public:
  Selection(const geometry::Tracer& tracer, const geometry::SectorId& id, const Candidates& candidates,
            const PlacementSettings& settings, const base::Progress& progress)
      : tracer_(tracer),
        id_(id),
        settings_(settings),
        progress_(progress),
        candidate_(candidates.candidate),
        walkable_(candidates.walkable),
        search_rays_(candidates.search_rays),
        kept_(candidate_.size(), false),
        near_candidate_(id),
        near_probe_(id) {
    for (std::size_t i = 0; i < candidate_.size(); ++i) near_candidate_.add(i, position(i));
  }

  void keepApart(PlacementReport& report) {
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      progress_.check();
      if (candidate_[i].by_hand || seenFrom(position(i), settings_.minimum_separation_m, 1).empty())
        keep(i);
      else
        ++report.near_others;
    }
  }

  void keepInSight(PlacementReport& report) {
    std::vector<std::uint8_t> covered(walkable_.size());
    tbb::parallel_for(std::size_t{0}, covered.size(), [&](std::size_t i) {
      progress_.check();
      covered[i] = seesAny(walkable_[i], [](std::size_t) { return true; }) ? 1 : 0;
    });
    const std::size_t first = probe_.size();
    std::vector<WalkablePoint> walkable;
    for (std::size_t i = 0; i < covered.size(); ++i) {
      const WalkablePoint& point = walkable_[i];
      if (covered[i] == 0) {
        progress_.check();
        if (!seesAny(point, [&](std::size_t p) { return p >= first; }) && !keepFor(point, report)) continue;
      }
      walkable.push_back(point);
    }
    walkable_ = std::move(walkable);
    report.added_for_sight = probe_.size() - first;
    report.walkable = walkable_.size();
  }

  /// Gives closed places their probe that no line of the lattices meets: ground under a roof that sees no probe at all.
  void keepInDark(PlacementReport& report) {
    const std::vector<WalkablePoint> narrow = narrowGround(tracer_, id_, settings_, progress_);
    const auto isDark = [&](const WalkablePoint& point, std::size_t first) {
      return seenFrom(point.foot, geometry::kSector_m, 1, [=](std::size_t p) { return p >= first; }).empty();
    };
    std::vector<std::uint8_t> dark(narrow.size());
    tbb::parallel_for(std::size_t{0}, dark.size(), [&](std::size_t i) {
      progress_.check();
      dark[i] = isDark(narrow[i], 0) ? 1 : 0;
    });
    const std::size_t first = probe_.size();
    for (std::size_t i = 0; i < narrow.size(); ++i) {
      if (dark[i] == 0 || !isDark(narrow[i], first)) continue;
      progress_.check();
      PlacementReport ignored;  // ground that one need not reach is no loss
      const auto own = candidateFor(tracer_, id_, settings_, narrow[i], ignored, search_rays_);
      if (!own) continue;
      candidate_.push_back(*own);
      kept_.push_back(false);
      keep(candidate_.size() - 1);
      walkable_.push_back(narrow[i]);
    }
    report.added_for_sight += probe_.size() - first;
    report.walkable = walkable_.size();
  }

  std::vector<geometry::Probe> finish(PlacementReport& report) const {
    std::vector<bool> by_hand;
    for (const std::size_t i : probe_) by_hand.push_back(candidate_[i].by_hand);
    const Look look = [&](std::size_t point, const std::vector<bool>& gone) {
      progress_.check();
      return seenFrom(walkable_[point].foot, settings_.coverage_m, kNearestSeen,
                      [&](std::size_t p) { return !gone[p]; });
    };
    std::vector<bool> gone(probe_.size(), false);
    for (const std::size_t i : thin(walkable_.size(), look, by_hand, geometry::kMostProbes)) {
      gone[i] = true;
      report.dropped.push_back({position(probe_[i]), DroppedProbe::Reason::thinned, by_hand[i]});
    }
    std::vector<std::uint8_t> covered(walkable_.size());
    tbb::parallel_for(std::size_t{0}, covered.size(), [&](std::size_t i) {
      progress_.check();
      covered[i] = seesAny(walkable_[i], [&](std::size_t p) { return !gone[p]; }) ? 1 : 0;
    });
    for (std::size_t i = 0; i < covered.size(); ++i)
      if (covered[i] == 0) report.uncovered.push_back(walkable_[i].foot);
    std::vector<geometry::Probe> result;
    for (std::size_t i = 0; i < probe_.size(); ++i)
      if (!gone[i]) result.push_back({position(probe_[i])});
    return result;
  }

 private:
  const Number3& position(std::size_t candidate) const { return candidate_[candidate].position; }

  void keep(std::size_t candidate) {
    kept_[candidate] = true;
    near_probe_.add(probe_.size(), position(candidate));
    probe_.push_back(candidate);
  }

  bool reaches(const Number3& from, const Number3& to) const {
    return roomOf(settings_, from) == roomOf(settings_, to) && sees(tracer_, from, to);
  }

  /// The `most` nearest probes that a point sees, among those that count.
  template <typename Counts>
  std::vector<SeenProbe> seenFrom(const Number3& from, double far_m, std::size_t most, const Counts& counts) const {
    std::vector<SeenProbe> result;
    near_probe_.visit(from, far_m, counts, [&](std::size_t i, double distance_m) {
      if (reaches(from, position(probe_[i]))) result.push_back({i, distance_m});
      return result.size() < most;
    });
    return result;
  }

  std::vector<SeenProbe> seenFrom(const Number3& from, double far_m, std::size_t most) const {
    return seenFrom(from, far_m, most, [](std::size_t) { return true; });
  }

  template <typename Counts>
  bool seesAny(const WalkablePoint& point, const Counts& counts) const {
    return !seenFrom(point.foot, settings_.coverage_m, 1, counts).empty();
  }

  /// Keeps a candidate for a point that sees no probe. Returns false if the point turns out not to be walkable ground.
  bool keepFor(const WalkablePoint& point, PlacementReport& report) {
    std::optional<std::size_t> nearest;
    near_candidate_.visit(
        point.foot, settings_.coverage_m, [&](std::size_t i) { return !kept_[i]; },
        [&](std::size_t i, double) {
          if (reaches(point.foot, position(i))) nearest = i;
          return !nearest;
        });
    if (nearest) {
      keep(*nearest);
    } else if (!point.on_lattice) {
      const auto own = candidateFor(tracer_, id_, settings_, point, report, search_rays_);
      if (!own) return report.dropped.back().reason != DroppedProbe::Reason::inside;
      candidate_.push_back(*own);
      kept_.push_back(false);
      keep(candidate_.size() - 1);
    }
    return true;
  }

  const geometry::Tracer& tracer_;
  geometry::SectorId id_;
  const PlacementSettings& settings_;
  const base::Progress& progress_;
  std::vector<Candidate> candidate_;
  std::vector<WalkablePoint> walkable_;
  std::size_t search_rays_;
  std::vector<bool> kept_;          // for each candidate
  std::vector<std::size_t> probe_;  // indices of candidates, in the order of choice
  Nearby near_candidate_;           // the sector's candidates, by index
  Nearby near_probe_;               // by index in probe_
};

}  // namespace

std::vector<geometry::Probe> selectProbes(const geometry::Tracer& tracer, const geometry::SectorId& id,
                                          const Candidates& candidates, const PlacementSettings& settings,
                                          PlacementReport& report, const base::Progress& progress) {
  Selection selection(tracer, id, candidates, settings, progress);
  selection.keepApart(report);
  selection.keepInSight(report);
  selection.keepInDark(report);
  return selection.finish(report);
}

}  // namespace welkin::placement
