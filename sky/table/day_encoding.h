// SPDX-License-Identifier: Apache-2.0
// The numbers of the day's table as a file stores them.
#pragma once

#include <cstdint>
#include <vector>

#include "format/day_numbers.h"
#include "sky/table/day_table.h"

namespace welkin::table {

using format::Encoding;

/// The arrays of table Day in runtime/format/welkin.fbs.
struct EncodedNumbers {
  Encoding encoding = Encoding::float32;
  std::vector<std::uint8_t> numbers;
  std::vector<float> key_scale;
  std::vector<float> row_scale;

  std::size_t bytes() const { return numbers.size() + 4 * (key_scale.size() + row_scale.size()); }
};

/// Encodes the numbers. float32 rounds each number. float16 divides by the key's largest number first: the error is
/// 2^-11 of the number and at least 2^-25 of that largest. The fixed-point encodings divide by the largest of the key,
/// then by the largest of the row. Their error is at most 1/65534 (fixed16) or 1/254 (fixed8) of the product of the
/// two.
EncodedNumbers encodeNumbers(const DayTable& table, Encoding encoding);

/// Returns the numbers as a reader decodes them, in the table's order.
std::vector<double> decodeNumbers(const DayTable& table, const EncodedNumbers& encoded);

}  // namespace welkin::table
