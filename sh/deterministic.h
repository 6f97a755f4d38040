// SPDX-License-Identifier: Apache-2.0
// The shared formulas in double with the same bits on every x86-64 machine: welkin::det is what baked files are made
// with. The C++ library picks its functions by processor; SLEEF's "cinz" functions are bit-identical everywhere
// (Shibata and Petrogalli, "SLEEF: A Portable Vectorized Library of C Standard Mathematical Functions", 2020), within
// 1 ulp. The rest is IEEE arithmetic, which -ffp-contract=off keeps unfused.
#pragma once

#include <sleef.h>

#include <cmath>

#include "shared.h"

#define INLINE inline
#define CONSTANT inline constexpr
#define NUMBER(literal) Number(literal)

namespace welkin::det {
using Number = double;
using Number3 = Vector3<Number>;
inline Number exp(Number x) {
  return Sleef_cinz_expd1_u10purec(x);
}
inline Number expMinusOne(Number x) {
  return Sleef_cinz_expm1d1_u10purec(x);
}
inline Number log(Number x) {
  return Sleef_cinz_logd1_u10purec(x);
}
inline Number pow(Number x, Number y) {
  return Sleef_cinz_powd1_u10purec(x, y);
}
inline Number sqrt(Number x) {
  return std::sqrt(x);
}
inline Number floor(Number x) {
  return std::floor(x);
}
inline Number sin(Number x) {
  return Sleef_cinz_sind1_u10purec(x);
}
inline Number cos(Number x) {
  return Sleef_cinz_cosd1_u10purec(x);
}
inline Number atan(Number y, Number x) {
  return Sleef_cinz_atan2d1_u10purec(y, x);
}
#include "formulas.glsl"  // NOLINT(bugprone-suspicious-include)
}  // namespace welkin::det

#undef NUMBER
#undef CONSTANT
#undef INLINE
