// SPDX-License-Identifier: Apache-2.0
// Numbers of any number of bits over a scale, for measuring what they would do.
#pragma once

#include <cmath>

namespace welkin::bench {

/// The nearest step of `bits` bits; 0 over a scale of 0.
inline double rounded(double value, double scale, int bits, bool is_signed) {
  const double steps = std::ldexp(1.0, is_signed ? bits - 1 : bits) - 1.0;
  return scale == 0.0 ? 0.0 : std::floor(value / scale * steps + 0.5) * scale / steps;
}

}  // namespace welkin::bench
