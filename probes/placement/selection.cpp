// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/selection.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "probes/placement/thinning.h"
#include "probes/placement/validity.h"

namespace welkin::probes {
namespace {

class Selection {
 public:
  Selection(const Tracer& tracer, const SectorId& id, const Candidates& candidates, const PlacementSettings& settings)
      : tracer_(tracer),
        id_(id),
        settings_(settings),
        candidate_(candidates.candidate),
        walkable_(candidates.walkable),
        kept_(candidate_.size(), false) {}

  void keepApart(PlacementReport& report) {
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      if (candidate_[i].by_hand || !nearAnother(i))
        keep(i);
      else
        ++report.near_others;
    }
  }

  void keepInSight(PlacementReport& report) {
    const Coverage coverage = coverageOf();
    const std::size_t first = probe_.size();
    std::vector<WalkablePoint> walkable;
    for (std::size_t i = 0; i < coverage.size(); ++i) {
      const WalkablePoint& point = walkable_[i];
      if (coverage[i].empty() && seenFrom(point.foot, first).empty() && !keepFor(point, report)) continue;
      walkable.push_back(point);
    }
    walkable_ = std::move(walkable);
    report.added_for_sight = probe_.size() - first;
    report.walkable = walkable_.size();
  }

  std::vector<Probe> finish(PlacementReport& report) const {
    const Coverage coverage = coverageOf();
    std::vector<bool> by_hand;
    for (const std::size_t i : probe_) by_hand.push_back(candidate_[i].by_hand);
    std::vector<bool> gone(probe_.size(), false);
    for (const std::size_t i : thin(coverage, by_hand, kMostProbes)) {
      gone[i] = true;
      report.dropped.push_back({position(probe_[i]), DroppedProbe::Reason::thinned, by_hand[i]});
    }
    for (std::size_t i = 0; i < coverage.size(); ++i)
      if (std::all_of(coverage[i].begin(), coverage[i].end(), [&](const SeenProbe& s) { return gone[s.probe]; }))
        report.uncovered.push_back(walkable_[i].foot);
    std::vector<Probe> result;
    for (std::size_t i = 0; i < probe_.size(); ++i)
      if (!gone[i]) result.push_back({position(probe_[i])});
    return result;
  }

 private:
  const Number3& position(std::size_t candidate) const { return candidate_[candidate].position; }

  void keep(std::size_t candidate) {
    kept_[candidate] = true;
    probe_.push_back(candidate);
  }

  bool reaches(const Number3& from, const Number3& to, double distance_m) const {
    return distanceOf(from, to) < distance_m && roomOf(settings_, from) == roomOf(settings_, to) &&
           sees(tracer_, from, to);
  }

  bool nearAnother(std::size_t candidate) const {
    return std::any_of(probe_.begin(), probe_.end(), [&](std::size_t other) {
      return reaches(position(candidate), position(other), settings_.minimum_separation_m);
    });
  }

  /// Probes from the `first` on that a point sees.
  std::vector<SeenProbe> seenFrom(const Number3& foot, std::size_t first) const {
    std::vector<SeenProbe> result;
    for (std::size_t i = first; i < probe_.size(); ++i)
      if (reaches(foot, position(probe_[i]), settings_.coverage_m))
        result.push_back({i, distanceOf(foot, position(probe_[i]))});
    std::stable_sort(result.begin(), result.end(),
                     [](const SeenProbe& a, const SeenProbe& b) { return a.distance_m < b.distance_m; });
    return result;
  }

  Coverage coverageOf() const {
    Coverage result(walkable_.size());
    tbb::parallel_for(std::size_t{0}, result.size(),
                      [&](std::size_t i) { result[i] = seenFrom(walkable_[i].foot, 0); });
    return result;
  }

  /// Keeps a candidate for a point that sees no probe. False where the point turns out to be no ground to walk on.
  bool keepFor(const WalkablePoint& point, PlacementReport& report) {
    std::optional<std::size_t> nearest;
    double limit = settings_.coverage_m;
    for (std::size_t i = 0; i < kept_.size(); ++i)
      if (!kept_[i] && reaches(point.foot, position(i), limit)) {
        nearest = i;
        limit = distanceOf(point.foot, position(i));
      }
    if (nearest) {
      keep(*nearest);
    } else if (!point.on_lattice) {
      const auto own = candidateFor(tracer_, id_, settings_, point, report);
      if (!own) return report.dropped.back().reason != DroppedProbe::Reason::inside;
      candidate_.push_back(*own);
      kept_.push_back(false);
      keep(candidate_.size() - 1);
    }
    return true;
  }

  const Tracer& tracer_;
  SectorId id_;
  const PlacementSettings& settings_;
  std::vector<Candidate> candidate_;
  std::vector<WalkablePoint> walkable_;
  std::vector<bool> kept_;          // by candidate
  std::vector<std::size_t> probe_;  // candidates, in the order of their choice
};

}  // namespace

std::vector<Probe> selectProbes(const Tracer& tracer, const SectorId& id, const Candidates& candidates,
                                const PlacementSettings& settings, PlacementReport& report) {
  Selection selection(tracer, id, candidates, settings);
  selection.keepApart(report);
  selection.keepInSight(report);
  return selection.finish(report);
}

}  // namespace welkin::probes
