// SPDX-License-Identifier: Apache-2.0
// Fixed-point numbers relative to a scale that is stored in 16 bits.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace welkin::transfer {

/// The scale for numbers up to `largest`, in [0, 3e38]: the upper 16 bits of a float32. It is the smallest such float32
/// that is not below `largest`.
inline std::uint16_t scaleFor(double largest) {
  auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(largest)) & 0xffff0000U;
  if (double{std::bit_cast<float>(bits)} < largest) bits += 0x10000U;
  return static_cast<std::uint16_t>(bits >> 16);
}

inline double scaleOf(std::uint16_t bits) {
  return double{std::bit_cast<float>(std::uint32_t{bits} << 16)};
}

/// `value` rounded to the nearest step of `scale` / largest Integer; 0 if `scale` is 0. The magnitude of `value` is at
/// most `scale`.
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
