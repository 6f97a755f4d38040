// SPDX-License-Identifier: Apache-2.0
// What was found of places in the air about a cell, so that each place is asked about once.
#pragma once

#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "probes/placement/cut_samples.h"

namespace welkin::placement {

/// Answers of one cell, on one thread. Many points of a cell have the same nearest place in a cell beside it.
class AirMemo {
 public:
  /// All three must outlive it. `near`: the probes that nearestSeen looks at.
  AirMemo(const geometry::Tracer& tracer, const CutSampler& sampler, const std::vector<std::size_t>& near)
      : tracer_(tracer), sampler_(sampler), near_(near) {}

  /// As CutSampler::nearestSeen: the nearest probe in sight of a place, or nothing.
  std::optional<std::size_t> nearestSeen(const Number3& place);
  /// As insideGeometry.
  bool isInside(const Number3& place);

 private:
  using Key = std::tuple<double, double, double>;

  const geometry::Tracer& tracer_;
  const CutSampler& sampler_;
  const std::vector<std::size_t>& near_;
  std::map<Key, std::optional<std::size_t>> seen_;
  std::map<Key, bool> inside_;
};

}  // namespace welkin::placement
