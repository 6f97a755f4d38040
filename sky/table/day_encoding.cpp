// SPDX-License-Identifier: Apache-2.0
#include "sky/table/day_encoding.h"

#include <Imath/half.h>

#include <algorithm>
#include <cmath>

namespace welkin::table {
namespace {

/// The smallest float that is not below the value.
float roundedUp(double value) {
  const auto rounded = static_cast<float>(value);
  return double{rounded} < value ? std::nextafter(rounded, INFINITY) : rounded;
}

template <typename T>
void append(std::vector<std::uint8_t>& bytes, T value) {
  const auto* p = reinterpret_cast<const std::uint8_t*>(&value);
  bytes.insert(bytes.end(), p, p + sizeof value);
}

}  // namespace

EncodedNumbers encodeNumbers(const DayTable& table, Encoding encoding) {
  EncodedNumbers out;
  out.encoding = encoding;
  const std::size_t count = table.numbersOfKey();
  const std::size_t keys = table.key_time_h.size();
  if (format::hasKeyScale(encoding))
    for (std::size_t key = 0; key < keys; ++key) {
      double largest = 0.0;
      for (std::size_t i = 0; i < count; ++i) largest = std::max(largest, std::abs(table.number[key * count + i]));
      out.key_scale.push_back(roundedUp(largest));
    }
  const auto ofKey = [&](std::size_t key, std::size_t i) {  // 0 where the whole key is 0
    const double scale = double{out.key_scale[key]};
    return scale > 0.0 ? table.number[key * count + i] / scale : 0.0;
  };
  if (format::hasRowScale(encoding))
    for (std::size_t i = 0; i < count; ++i) {
      double largest = 0.0;
      for (std::size_t key = 0; key < keys; ++key) largest = std::max(largest, std::abs(ofKey(key, i)));
      out.row_scale.push_back(roundedUp(largest / format::factsOf(encoding).largest_integer));
    }
  format::visitEncoding(encoding, [&](auto constant) {
    using Stored = format::Stored<constant()>;
    for (std::size_t key = 0; key < keys; ++key)
      for (std::size_t i = 0; i < count; ++i)
        if constexpr (constant() == Encoding::float32) {
          append(out.numbers, static_cast<Stored>(table.number[key * count + i]));
        } else if constexpr (constant() == Encoding::float16) {
          append(out.numbers, Stored{Imath::half(static_cast<float>(ofKey(key, i))).bits()});
        } else {
          const double scale = double{out.row_scale[i]};
          append(out.numbers, static_cast<Stored>(scale > 0.0 ? std::lround(ofKey(key, i) / scale) : 0));
        }
  });
  return out;
}

std::vector<double> decodeNumbers(const DayTable& table, const EncodedNumbers& encoded) {
  std::vector<double> number(table.number.size());
  const std::size_t of_key = table.numbersOfKey();
  format::visitEncoding(encoded.encoding, [&](auto encoding) {
    for (std::size_t i = 0; i < number.size(); ++i) {
      number[i] = format::storedNumber<encoding()>(encoded.numbers.data(), i);
      if constexpr (format::hasKeyScale(encoding())) number[i] *= double{encoded.key_scale[i / of_key]};
      if constexpr (format::hasRowScale(encoding())) number[i] *= double{encoded.row_scale[i % of_key]};
    }
  });
  return number;
}

}  // namespace welkin::table
