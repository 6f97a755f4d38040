// SPDX-License-Identifier: Apache-2.0
// The shared formulas as C++, twice: welkin::f64 is the reference, welkin::f32 stands for the GPU. Both use the C++
// library's functions, whose last bit may depend on the machine. Numbers in a baked file use sh/deterministic.h
// instead.
#pragma once

#include <cmath>

#include "language.h"

#define INLINE inline
#define CONSTANT inline constexpr
#define NUMBER(literal) Number(literal)
#define SCALED(factor, value) ((factor) != Number(0) ? (factor) * (value) : Number(0))

#define WELKIN_STANDARD_FUNCTIONS          \
  inline Number exp(Number x) {            \
    return std::exp(x);                    \
  }                                        \
  inline Number expMinusOne(Number x) {    \
    return std::expm1(x);                  \
  }                                        \
  inline Number sqrt(Number x) {           \
    return std::sqrt(x);                   \
  }                                        \
  inline Number sin(Number x) {            \
    return std::sin(x);                    \
  }                                        \
  inline Number cos(Number x) {            \
    return std::cos(x);                    \
  }                                        \
  inline Number floor(Number x) {          \
    return std::floor(x);                  \
  }                                        \
  inline Number pow(Number x, Number y) {  \
    return std::pow(x, y);                 \
  }                                        \
  inline Number atan(Number y, Number x) { \
    return std::atan2(y, x);               \
  }

// NOLINTBEGIN(bugprone-suspicious-include)
namespace welkin::f64 {
using Number = double;
using Number3 = Vector3<Number>;
WELKIN_STANDARD_FUNCTIONS
#include "formulas.glsl"
}  // namespace welkin::f64

namespace welkin::f32 {
using Number = float;
using Number3 = Vector3<Number>;
WELKIN_STANDARD_FUNCTIONS
#include "formulas.glsl"
}  // namespace welkin::f32
// NOLINTEND(bugprone-suspicious-include)

#undef WELKIN_STANDARD_FUNCTIONS
#undef SCALED
#undef NUMBER
#undef CONSTANT
#undef INLINE
