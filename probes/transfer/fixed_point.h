// SPDX-License-Identifier: Apache-2.0
// Fixed point over a scale.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace welkin::transfer {

/// The least number that is not below `largest` and whose float32 has only its first 16 bits, as these bits. `largest`
/// in [0, 3e38].
inline std::uint16_t scaleFor(double largest) {
  auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(largest)) & 0xffff0000U;
  if (double{std::bit_cast<float>(bits)} < largest) bits += 0x10000U;
  return static_cast<std::uint16_t>(bits >> 16);
}

inline double scaleOf(std::uint16_t bits) {
  return double{std::bit_cast<float>(std::uint32_t{bits} << 16)};
}

/// The nearest step of `scale` / largest Integer; 0 for a scale of 0. `value` is at most `scale` in magnitude.
template <typename Integer>
Integer toFixed(double value, double scale) {
  if (scale == 0.0) return 0;
  return static_cast<Integer>(std::floor(value / scale * double{std::numeric_limits<Integer>::max()} + 0.5));
}

template <typename Integer>
double fromFixed(Integer step, double scale) {
  return static_cast<double>(step) * scale / double{std::numeric_limits<Integer>::max()};
}

}  // namespace welkin::transfer
