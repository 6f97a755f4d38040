// SPDX-License-Identifier: Apache-2.0
// IEEE 754 half precision to float, exactly, and back.
#pragma once

#include <bit>
#include <cstdint>

namespace welkin::format {

/// Value of a half, including subnormals, infinities and NaNs. One multiplication moves the exponent: Giesen (2012),
/// "half_to_float_fast".
inline float floatFromHalf(std::uint16_t half) {
  const auto magnitude = std::uint32_t{half & 0x7fffU} << 13;
  const float scaled = std::bit_cast<float>(magnitude) * 0x1p112F;
  const std::uint32_t infinite = magnitude >= (0x7c00U << 13) ? 0x7f800000U : 0U;
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(scaled) | infinite | std::uint32_t{half & 0x8000U} << 16);
}

/// The nearest half, ties to even; beyond the largest it becomes the largest. Giesen (2012),
/// "float_to_half_fast3_rtne".
inline std::uint16_t halfFromFloat(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const std::uint32_t sign = bits & 0x80000000U, magnitude = bits ^ sign;
  std::uint32_t half;
  if (magnitude >= 0x477ff000U) {
    half = 0x7bffU;
  } else if (magnitude < 0x38800000U) {  // a subnormal half: one addition aligns and rounds it
    half = std::bit_cast<std::uint32_t>(std::bit_cast<float>(magnitude) + 0.5F) - 0x3f000000U;
  } else {
    half = (magnitude + 0xc8000fffU + (magnitude >> 13 & 1U)) >> 13;
  }
  return static_cast<std::uint16_t>(half | sign >> 16);
}

/// Whether a half is neither an infinity nor a NaN.
inline bool isFiniteHalf(std::uint16_t half) {
  return (half & 0x7c00U) != 0x7c00U;
}

}  // namespace welkin::format
