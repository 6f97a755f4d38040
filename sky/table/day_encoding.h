// SPDX-License-Identifier: Apache-2.0
// The numbers of the day's table as a file stores them.
#pragma once

#include <cstdint>
#include <vector>

#include "format/day_numbers.h"
#include "sky/table/day_table.h"

namespace welkin::table {

using format::Encoding;

/// runtime/format/welkin.fbs, table Day.
struct EncodedNumbers {
  Encoding encoding = Encoding::float32;
  std::vector<std::uint8_t> numbers;
  std::vector<float> key_scale;
  std::vector<float> row_scale;

  std::size_t bytes() const { return numbers.size() + 4 * (key_scale.size() + row_scale.size()); }
};

/// float32 rounds each number. float16 stores it over the largest of its key: 2^-11 of itself, 2^-25 of that largest at
/// the least. The fixed-point encodings store it over the largest of its key and over the largest that its row then
/// has: off by at most 1/65534 (fixed16) or 1/254 (fixed8) of the product of the two.
EncodedNumbers encodeNumbers(const DayTable& table, Encoding encoding);

/// The numbers that a reader gets, in the table's order.
std::vector<double> decodeNumbers(const DayTable& table, const EncodedNumbers& encoded);

}  // namespace welkin::table
