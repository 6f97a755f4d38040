// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/thinning.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <compare>
#include <set>

namespace welkin::placement {
namespace {

struct Loss {
  bool by_hand = false;
  std::size_t points = 0;
  double distance_m = 0.0;
  auto operator<=>(const Loss&) const = default;
};

/// The least loss first; among equal losses the later probe.
struct LeastFirst {
  const std::vector<Loss>* loss;
  bool operator()(std::size_t a, std::size_t b) const {
    const auto order = (*loss)[a] <=> (*loss)[b];
    return order == 0 ? a > b : order < 0;
  }
};

/// Only the nearest probe that a point sees has a part in its loss. So when a probe goes, the losses of only a few
/// others change. These are summed again in the order of points, so sums do not depend on earlier steps.
class Thinning {
 public:
  Thinning(std::size_t points, const Look& look, const std::vector<bool>& by_hand)
      : look_(look), gone_(by_hand.size(), false), nearest_to_(by_hand.size()), next_to_(by_hand.size()) {
    for (const bool b : by_hand) loss_.push_back({b});
    seen_.resize(points);
    tbb::parallel_for(std::size_t{0}, points, [&](std::size_t i) { lookFrom(i); });
    for (std::size_t i = 0; i < points; ++i) {
      const std::vector<SeenProbe>& seen = seen_[i].probe;
      if (!seen.empty()) nearest_to_[seen[0].probe].push_back(i);
      if (seen.size() > 1) next_to_[seen[1].probe].push_back(i);
    }
    for (std::size_t p = 0; p < loss_.size(); ++p) {
      addLoss(p);
      order_.insert(p);
    }
  }

  std::size_t takeLeast() {
    const std::size_t least = *order_.begin();
    order_.erase(order_.begin());
    gone_[least] = true;
    std::vector<std::size_t> point = nearest_to_[least];
    const std::size_t lost_nearest = point.size();
    for (const std::size_t i : next_to_[least])
      if (seen_[i].probe.size() > 1 && seen_[i].probe[1].probe == least) point.push_back(i);
    tbb::parallel_for(std::size_t{0}, point.size(), [&](std::size_t n) { lookOn(point[n]); });
    std::set<std::size_t> changed;
    for (std::size_t n = 0; n < point.size(); ++n) {
      const std::vector<SeenProbe>& seen = seen_[point[n]].probe;
      if (seen.empty()) continue;
      changed.insert(seen[0].probe);
      if (n < lost_nearest) nearest_to_[seen[0].probe].push_back(point[n]);
      if (seen.size() > 1) next_to_[seen[1].probe].push_back(point[n]);
    }
    for (const std::size_t p : changed) {
      order_.erase(p);
      std::sort(nearest_to_[p].begin(), nearest_to_[p].end());
      loss_[p] = {loss_[p].by_hand};
      addLoss(p);
      order_.insert(p);
    }
    nearest_to_[least] = {};
    next_to_[least] = {};
    return least;
  }

 private:
  struct Seen {
    std::vector<SeenProbe> probe;  ///< the first two are still there
    bool all = false;              ///< the point sees no farther probe
  };

  void lookFrom(std::size_t point) {
    seen_[point].probe = look_(point, gone_);
    seen_[point].all = seen_[point].probe.size() < kNearestSeen;
  }

  /// Updates a point after one of its first two probes has gone.
  void lookOn(std::size_t point) {
    Seen& seen = seen_[point];
    std::erase_if(seen.probe, [&](const SeenProbe& s) { return gone_[s.probe]; });
    if (seen.probe.size() < 2 && !seen.all) lookFrom(point);
  }

  void addLoss(std::size_t probe) {
    for (const std::size_t i : nearest_to_[probe]) {
      const std::vector<SeenProbe>& seen = seen_[i].probe;
      if (seen.size() == 1)
        ++loss_[probe].points;
      else
        loss_[probe].distance_m += seen[1].distance_m - seen[0].distance_m;
    }
  }

  const Look& look_;
  std::vector<bool> gone_;
  std::vector<Seen> seen_;                            // for each point
  std::vector<std::vector<std::size_t>> nearest_to_;  // for each probe, the points that see no nearer one, ascending
  std::vector<std::vector<std::size_t>> next_to_;     // for each probe, the points that once saw one nearer probe
  std::vector<Loss> loss_;
  std::set<std::size_t, LeastFirst> order_{LeastFirst{&loss_}};
};

}  // namespace

std::vector<std::size_t> thin(std::size_t points, const Look& look, const std::vector<bool>& by_hand,
                              std::size_t most) {
  std::vector<std::size_t> result;
  if (by_hand.size() <= most) return result;
  Thinning thinning(points, look, by_hand);
  while (by_hand.size() - result.size() > most) result.push_back(thinning.takeLeast());
  return result;
}

}  // namespace welkin::placement
