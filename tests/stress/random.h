// SPDX-License-Identifier: Apache-2.0
// Counter-based random numbers. The n-th number of a seed and an index is a hash of the three, so any draw can be
// repeated without the draws before it.
#pragma once

#include <cmath>
#include <cstdint>

#include "probes/geometry/random.h"

namespace welkin::stress {

class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t index) : key_(geometry::mixed(geometry::mixed(seed) ^ index)) {}

  /// Uniform in [0, 1), 53 bits.
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// Uniform in 0 .. count - 1; the bias of count / 2^64 is negligible.
  int below(int count) { return static_cast<int>(next() % static_cast<std::uint64_t>(count)); }
  bool once(int of) { return below(of) == 0; }
  /// Log-uniform in [low, high); 0 < low < high.
  double magnitude(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }

 private:
  std::uint64_t next() { return geometry::mixed(key_ ^ geometry::mixed(++counter_)); }

  std::uint64_t key_;
  std::uint64_t counter_ = 0;
};

}  // namespace welkin::stress
