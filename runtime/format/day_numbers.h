// SPDX-License-Identifier: Apache-2.0
// The storage of the numbers of the day's table.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "format/half.h"
#include "welkin_generated.h"

namespace welkin::format {

/// An encoding of the table's numbers. A fixed-point encoding stores integers that are symmetric about 0.
struct EncodingFacts {
  Encoding encoding;
  std::size_t bytes;  ///< per number
  bool has_key_scale;
  int largest_integer;  ///< of a fixed-point encoding, which has scales of rows; 0: not fixed-point
};

/// Every encoding, from the finest to the coarsest.
inline constexpr std::array<EncodingFacts, 4> kEncodingFacts = {{{Encoding::float32, 4, false, 0},
                                                                 {Encoding::float16, 2, true, 0},
                                                                 {Encoding::fixed16, 2, true, 32767},
                                                                 {Encoding::fixed8, 1, true, 127}}};
static_assert(kEncodingFacts.size() == static_cast<std::size_t>(Encoding::MAX) + 1);

inline constexpr auto kEncodings = [] {
  std::array<Encoding, kEncodingFacts.size()> list{};
  for (std::size_t i = 0; i < list.size(); ++i) list[i] = kEncodingFacts[i].encoding;
  return list;
}();

/// Facts of an encoding that checkContent lets pass.
constexpr const EncodingFacts& factsOf(Encoding encoding) {
  std::size_t i = 0;
  while (i + 1 < kEncodingFacts.size() && kEncodingFacts[i].encoding != encoding) ++i;
  return kEncodingFacts[i];
}

/// Calls `callable` with the encoding as a constant: std::integral_constant<Encoding, ...>.
template <typename Callable>
void visitEncoding(Encoding encoding, Callable&& callable) {
  const auto visit = [&]<std::size_t... kI>(std::index_sequence<kI...>) {
    ((kEncodings[kI] == encoding ? callable(std::integral_constant<Encoding, kEncodings[kI]>()) : void()), ...);
  };
  visit(std::make_index_sequence<kEncodings.size()>());
}

/// Name of an encoding: "float32", "float16", "fixed16" or "fixed8".
inline const char* nameOf(Encoding encoding) {
  return EnumNameEncoding(encoding);
}

constexpr std::size_t bytesOf(Encoding encoding) {
  return factsOf(encoding).bytes;
}

constexpr bool hasKeyScale(Encoding encoding) {
  return factsOf(encoding).has_key_scale;
}
constexpr bool hasRowScale(Encoding encoding) {
  return factsOf(encoding).largest_integer > 0;
}

/// Bytes of one key of the table in a file: its time, its scale, and `numbers` numbers (one per row and channel).
constexpr std::size_t bytesOfKey(Encoding encoding, std::size_t numbers) {
  return sizeof(double) + numbers * bytesOf(encoding) + (hasKeyScale(encoding) ? sizeof(float) : 0);
}
/// Bytes of the table in a file: its keys, and the scales of its rows and channels.
constexpr std::size_t bytesOfTable(Encoding encoding, std::size_t keys, std::size_t numbers) {
  return keys * bytesOfKey(encoding, numbers) + (hasRowScale(encoding) ? numbers * sizeof(float) : 0);
}

/// Number of rows of a table of SH coefficients: the coefficients with m >= 0.
constexpr std::size_t polarCount(std::size_t bands) {
  return bands * (bands + 1) / 2;
}

/// Type of a stored number: a float, the bits of a half, or an integer.
template <Encoding kEncoding>
using Stored =
    std::conditional_t<kEncoding == Encoding::float32, float,
                       std::conditional_t<kEncoding == Encoding::float16, std::uint16_t,
                                          std::conditional_t<bytesOf(kEncoding) == 1, std::int8_t, std::int16_t>>>;

/// Number `i` of a table as it is stored, before its scales. `numbers` holds bytesOf(encoding) bytes for each.
template <Encoding kEncoding>
double storedNumber(const std::uint8_t* numbers, std::size_t i) {
  Stored<kEncoding> stored;
  static_assert(sizeof stored == bytesOf(kEncoding));
  std::memcpy(&stored, numbers + i * sizeof stored, sizeof stored);
  if constexpr (kEncoding == Encoding::float16)
    return double{floatFromHalf(stored)};
  else
    return static_cast<double>(stored);
}

}  // namespace welkin::format
