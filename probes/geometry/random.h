// SPDX-License-Identifier: Apache-2.0
// Counter-based random numbers: number n of a key is a hash of n and the key. A sample is the same whoever draws it,
// and when.
#pragma once

#include <cstdint>

namespace welkin::geometry {

/// The finaliser of SplitMix64 (Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators", 2014).
constexpr std::uint64_t mixed(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

class Random {
 public:
  /// Keys from the widest to the narrowest: sector, probe, sample.
  template <typename... Keys>
  explicit constexpr Random(Keys... keys) {
    ((key_ = mixed(key_ ^ static_cast<std::uint64_t>(keys))), ...);
  }

  constexpr std::uint64_t next() { return mixed(key_ ^ mixed(++counter_)); }
  /// Uniform in [0, 1), 53 bits.
  constexpr double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

 private:
  std::uint64_t key_ = 0;
  std::uint64_t counter_ = 0;
};

}  // namespace welkin::geometry
