// SPDX-License-Identifier: Apache-2.0
// The storage of the numbers of the day's table.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "format/half.h"
#include "welkin_generated.h"

namespace welkin::format {

/// Largest stored integers of the fixed-point encodings: they are symmetric about 0.
inline constexpr int kLargestFixed16 = 32767;
inline constexpr int kLargestFixed8 = 127;

/// "float32", "float16", "fixed16", "fixed8".
inline const char* nameOf(Encoding encoding) {
  return EnumNameEncoding(encoding);
}

constexpr std::size_t bytesOf(Encoding encoding) {
  return encoding == Encoding::float32 ? 4 : encoding == Encoding::fixed8 ? 1 : 2;
}

constexpr bool hasKeyScale(Encoding encoding) {
  return encoding != Encoding::float32;
}
constexpr bool hasRowScale(Encoding encoding) {
  return encoding == Encoding::fixed16 || encoding == Encoding::fixed8;
}

/// Rows of a table of SH coefficients, of which it holds those with m >= 0.
constexpr std::size_t polarCount(std::size_t bands) {
  return bands * (bands + 1) / 2;
}

/// Number `i` of a table as it is stored, before its scales. `numbers` holds bytesOf(encoding) bytes for each.
template <Encoding kEncoding>
double storedNumber(const std::uint8_t* numbers, std::size_t i) {
  const std::uint8_t* at = numbers + i * bytesOf(kEncoding);
  if constexpr (kEncoding == Encoding::float32) {
    float v;
    std::memcpy(&v, at, sizeof v);
    return double{v};
  } else if constexpr (kEncoding == Encoding::fixed8) {
    return static_cast<std::int8_t>(*at);
  } else {
    std::uint16_t bits;
    std::memcpy(&bits, at, sizeof bits);
    if constexpr (kEncoding == Encoding::float16)
      return double{floatFromHalf(bits)};
    else
      return static_cast<std::int16_t>(bits);
  }
}

}  // namespace welkin::format
