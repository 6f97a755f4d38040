// SPDX-License-Identifier: Apache-2.0
// Rounds numbers to any number of bits over a scale, to measure the error.
#pragma once

#include <cmath>

namespace welkin::bench {

/// `value` rounded to the nearest step of `bits` bits over `scale`; 0 when the scale is 0.
inline double rounded(double value, double scale, int bits, bool is_signed) {
  const double steps = std::ldexp(1.0, is_signed ? bits - 1 : bits) - 1.0;
  return scale == 0.0 ? 0.0 : std::floor(value / scale * steps + 0.5) * scale / steps;
}

}  // namespace welkin::bench
