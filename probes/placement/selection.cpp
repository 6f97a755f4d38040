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
  Selection(const Tracer& tracer, const Candidates& candidates, const PlacementSettings& settings)
      : tracer_(tracer), candidates_(candidates), settings_(settings), kept_(candidates.candidate.size(), false) {}

  void keepApart(PlacementReport& report) {
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      if (candidates_.candidate[i].by_hand || !nearAnother(i))
        keep(i);
      else
        ++report.near_others;
    }
  }

  void keepInSight(PlacementReport& report) {
    const Coverage coverage = coverageOf(0);
    const std::size_t first = probe_.size();
    for (std::size_t i = 0; i < coverage.size(); ++i) {
      if (!coverage[i].empty() || !seenFrom(i, first).empty()) continue;
      if (const auto nearest = nearestLeft(i)) {
        keep(*nearest);
        ++report.added_for_sight;
      }
    }
  }

  std::vector<Probe> finish(PlacementReport& report) const {
    const Coverage coverage = coverageOf(0);
    std::vector<bool> by_hand;
    for (const std::size_t i : probe_) by_hand.push_back(candidates_.candidate[i].by_hand);
    std::vector<bool> gone(probe_.size(), false);
    for (const std::size_t i : thin(coverage, by_hand, kMostProbes)) {
      gone[i] = true;
      report.dropped.push_back({position(probe_[i]), DroppedProbe::Reason::thinned, by_hand[i]});
    }
    for (std::size_t i = 0; i < coverage.size(); ++i)
      if (std::all_of(coverage[i].begin(), coverage[i].end(), [&](const SeenProbe& s) { return gone[s.probe]; }))
        report.uncovered.push_back(candidates_.walkable[i]);
    std::vector<Probe> result;
    for (std::size_t i = 0; i < probe_.size(); ++i)
      if (!gone[i]) result.push_back({position(probe_[i])});
    return result;
  }

 private:
  const Number3& position(std::size_t candidate) const { return candidates_.candidate[candidate].position; }

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

  /// Probes that a walkable point sees, of those from the `first`.
  std::vector<SeenProbe> seenFrom(std::size_t point, std::size_t first) const {
    std::vector<SeenProbe> result;
    const Number3& foot = candidates_.walkable[point];
    for (std::size_t i = first; i < probe_.size(); ++i)
      if (reaches(foot, position(probe_[i]), settings_.coverage_m))
        result.push_back({i, distanceOf(foot, position(probe_[i]))});
    std::stable_sort(result.begin(), result.end(),
                     [](const SeenProbe& a, const SeenProbe& b) { return a.distance_m < b.distance_m; });
    return result;
  }

  Coverage coverageOf(std::size_t first) const {
    Coverage result(candidates_.walkable.size());
    tbb::parallel_for(std::size_t{0}, result.size(), [&](std::size_t i) { result[i] = seenFrom(i, first); });
    return result;
  }

  std::optional<std::size_t> nearestLeft(std::size_t point) const {
    const Number3& foot = candidates_.walkable[point];
    std::optional<std::size_t> nearest;
    double limit = settings_.coverage_m;
    for (std::size_t i = 0; i < kept_.size(); ++i)
      if (!kept_[i] && reaches(foot, position(i), limit)) {
        nearest = i;
        limit = distanceOf(foot, position(i));
      }
    return nearest;
  }

  const Tracer& tracer_;
  const Candidates& candidates_;
  const PlacementSettings& settings_;
  std::vector<bool> kept_;          // by candidate
  std::vector<std::size_t> probe_;  // candidates, in the order of their choice
};

}  // namespace

std::vector<Probe> selectProbes(const Tracer& tracer, const Candidates& candidates, const PlacementSettings& settings,
                                PlacementReport& report) {
  Selection selection(tracer, candidates, settings);
  selection.keepApart(report);
  selection.keepInSight(report);
  return selection.finish(report);
}

}  // namespace welkin::probes
