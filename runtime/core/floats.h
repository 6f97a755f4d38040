// SPDX-License-Identifier: Apache-2.0
// Conversion of doubles to the float fields of the C interface, and back.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "shared.h"

namespace welkin::core {

static_assert(std::numeric_limits<float>::is_iec559 && std::numeric_limits<double>::is_iec559);

/// The nearest float; a value past float's range becomes the largest of its sign. NaN stays NaN.
inline float toFloat(double value) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  return static_cast<float>(std::min(std::max(value, -kLargest), kLargest));  // in this order NaN stays
}

/// Stores `count` numbers in a row, in a loop that compilers can vectorise.
inline void store(const double* value, std::size_t count, float* out) {
  for (std::size_t i = 0; i < count; ++i) out[i] = toFloat(value[i]);
}

inline void store(const f64::Number3& v, float out[3]) {
  out[0] = toFloat(v.x);
  out[1] = toFloat(v.y);
  out[2] = toFloat(v.z);
}

inline f64::Number3 load(const float v[3]) {
  return {double{v[0]}, double{v[1]}, double{v[2]}};
}

}  // namespace welkin::core
