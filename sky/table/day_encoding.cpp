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

/// Largest stored integer of a fixed-point encoding.
double largestInteger(Encoding encoding) {
  return encoding == Encoding::fixed8 ? format::kLargestFixed8 : format::kLargestFixed16;
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
      out.row_scale.push_back(roundedUp(largest / largestInteger(encoding)));
    }
  for (std::size_t key = 0; key < keys; ++key)
    for (std::size_t i = 0; i < count; ++i) switch (encoding) {
        case Encoding::float32:
          append(out.numbers, static_cast<float>(table.number[key * count + i]));
          break;
        case Encoding::float16:
          append(out.numbers, Imath::half(static_cast<float>(ofKey(key, i))).bits());
          break;
        case Encoding::fixed16:
        case Encoding::fixed8: {
          const double scale = double{out.row_scale[i]};
          const long q = scale > 0.0 ? std::lround(ofKey(key, i) / scale) : 0;
          if (encoding == Encoding::fixed16)
            append(out.numbers, static_cast<std::int16_t>(q));
          else
            append(out.numbers, static_cast<std::int8_t>(q));
          break;
        }
      }
  return out;
}

std::vector<double> decodeNumbers(const DayTable& table, const EncodedNumbers& encoded) {
  const auto stored = [&](std::size_t i) {
    switch (encoded.encoding) {
      case Encoding::float32:
        return format::storedNumber<Encoding::float32>(encoded.numbers.data(), i);
      case Encoding::float16:
        return format::storedNumber<Encoding::float16>(encoded.numbers.data(), i);
      case Encoding::fixed16:
        return format::storedNumber<Encoding::fixed16>(encoded.numbers.data(), i);
      case Encoding::fixed8:
        break;
    }
    return format::storedNumber<Encoding::fixed8>(encoded.numbers.data(), i);
  };
  std::vector<double> number(table.number.size());
  const std::size_t of_key = table.numbersOfKey();
  for (std::size_t i = 0; i < number.size(); ++i) {
    number[i] = stored(i);
    if (format::hasKeyScale(encoded.encoding)) number[i] *= double{encoded.key_scale[i / of_key]};
    if (format::hasRowScale(encoded.encoding)) number[i] *= double{encoded.row_scale[i % of_key]};
  }
  return number;
}

}  // namespace welkin::table
