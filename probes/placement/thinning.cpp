// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/thinning.h"

#include <compare>

namespace welkin::probes {
namespace {

struct Loss {
  bool by_hand = false;
  std::size_t points = 0;
  double distance_m = 0.0;
  auto operator<=>(const Loss&) const = default;
};

/// What each probe's going would cost: only the nearest that a point sees has a part in it.
std::vector<Loss> lossOf(const Coverage& coverage, const std::vector<bool>& gone, const std::vector<bool>& by_hand) {
  std::vector<Loss> loss(gone.size());
  for (std::size_t i = 0; i < loss.size(); ++i) loss[i].by_hand = by_hand[i];
  for (const std::vector<SeenProbe>& seen : coverage) {
    const SeenProbe* nearest = nullptr;
    const SeenProbe* next = nullptr;
    for (const SeenProbe& s : seen) {
      if (gone[s.probe]) continue;
      if (nearest != nullptr) {
        next = &s;
        break;
      }
      nearest = &s;
    }
    if (nearest == nullptr) continue;
    if (next == nullptr)
      ++loss[nearest->probe].points;
    else
      loss[nearest->probe].distance_m += next->distance_m - nearest->distance_m;
  }
  return loss;
}

}  // namespace

std::vector<std::size_t> thin(const Coverage& coverage, const std::vector<bool>& by_hand, std::size_t most) {
  std::vector<bool> gone(by_hand.size(), false);
  std::vector<std::size_t> result;
  while (by_hand.size() - result.size() > most) {
    const std::vector<Loss> loss = lossOf(coverage, gone, by_hand);
    std::size_t least = by_hand.size();
    for (std::size_t i = 0; i < loss.size(); ++i)
      if (!gone[i] && (least == by_hand.size() || loss[i] <= loss[least])) least = i;
    gone[least] = true;
    result.push_back(least);
  }
  return result;
}

}  // namespace welkin::probes
