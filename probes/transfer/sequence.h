// SPDX-License-Identifier: Apache-2.0
// Low-discrepancy points for paths: the first two dimensions of Sobol's sequence, shuffled and shifted by a key. The
// key makes sequences side by side independent. It uses integers only, and any first 2^m points are a net. Sobol, "On
// the Distribution of Points in a Cube and the Approximate Evaluation of Integrals" (1967); Burley, "Practical
// Hash-based Owen Scrambling" (2020).
#pragma once

#include <cstdint>

#include "probes/geometry/random.h"

namespace welkin::transfer {

/// The bits of a number in reverse order.
constexpr std::uint32_t reversedBits(std::uint32_t x) {
  x = __builtin_bswap32(x);
  x = ((x >> 4) & 0x0f0f0f0fU) | ((x & 0x0f0f0f0fU) << 4);
  x = ((x >> 2) & 0x33333333U) | ((x & 0x33333333U) << 2);
  return ((x >> 1) & 0x55555555U) | ((x & 0x55555555U) << 1);
}

/// The middle of step x of 2^32, as a fraction in (0, 1).
constexpr double fractionOf(std::uint32_t x) {
  return (static_cast<double>(x) + 0.5) * 0x1p-32;
}

class Sequence {
 public:
  struct Point {
    std::uint32_t s, t;  ///< fractions of 2^32
  };

  explicit constexpr Sequence(std::uint64_t key)
      : shuffle_(static_cast<std::uint32_t>(geometry::mixed(key))),
        shift_{static_cast<std::uint32_t>(geometry::mixed(key + 1)),
               static_cast<std::uint32_t>(geometry::mixed(key + 2))} {}

  constexpr Point point(std::uint32_t i) const {
    const std::uint32_t reversed = shuffled(i);
    return {reversed ^ shift_.s, pascal(reversed) ^ shift_.t};
  }

  /// The first coordinate of point i.
  constexpr std::uint32_t value(std::uint32_t i) const { return shuffled(i) ^ shift_.s; }

 private:
  /// Laine and Karras' hash of the index from its highest bit down. Blocks of 2^m indices stay together.
  constexpr std::uint32_t shuffled(std::uint32_t i) const {
    std::uint32_t x = reversedBits(i) + shuffle_;
    x ^= x * 0x6c50b47cU;
    x ^= x * 0xb82f1e52U;
    x ^= x * 0xc7afe638U;
    return x ^ (x * 0x8d22f6e6U);
  }

  /// Pascal's triangle modulo 2, the second dimension's matrix, as a Kronecker product of its 2 x 2 block.
  static constexpr std::uint32_t pascal(std::uint32_t x) {
    x ^= (x & 0x55555555U) << 1;
    x ^= (x & 0x33333333U) << 2;
    x ^= (x & 0x0f0f0f0fU) << 4;
    x ^= (x & 0x00ff00ffU) << 8;
    return x ^ (x << 16);
  }

  std::uint32_t shuffle_;
  Point shift_;
};

}  // namespace welkin::transfer
