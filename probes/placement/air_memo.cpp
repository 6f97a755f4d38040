// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/air_memo.h"

#include "probes/placement/validity.h"

namespace welkin::placement {

std::optional<std::size_t> AirMemo::nearestSeen(const Number3& place) {
  const auto [found, is_new] = seen_.try_emplace(Key(place.x, place.y, place.z));
  if (is_new) found->second = sampler_.nearestSeen(place, near_, nullptr);
  return found->second;
}

bool AirMemo::isInside(const Number3& place) {
  const auto [found, is_new] = inside_.try_emplace(Key(place.x, place.y, place.z));
  if (is_new) found->second = insideGeometry(tracer_, place);
  return found->second;
}

}  // namespace welkin::placement
