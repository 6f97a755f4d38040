// SPDX-License-Identifier: Apache-2.0
// Numbers without the standard library's distributions, and a checksum of doubles: both the same on every machine.
#pragma once

#include <bit>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

namespace welkin::tests {

/// `count` numbers in [-1, 1).
inline std::vector<double> randomNumbers(std::size_t count, std::uint32_t seed) {
  std::mt19937 generator(seed);
  std::vector<double> number(count);
  for (double& x : number) x = generator() / 2147483648.0 - 1.0;
  return number;
}

/// FNV-1a over the bits, least significant byte first.
inline std::uint64_t checksum(std::span<const double> number) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const double x : number)
    for (int byte = 0; byte < 8; ++byte)
      hash = (hash ^ (std::bit_cast<std::uint64_t>(x) >> (8 * byte) & 0xff)) * 0x100000001b3u;
  return hash;
}

}  // namespace welkin::tests
