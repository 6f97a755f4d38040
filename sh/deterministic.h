// SPDX-License-Identifier: Apache-2.0
// The shared formulas in double with the same bits on every x86-64 and ARM64 machine. Bakes use them: namespace
// welkin::det. The C++ library picks its functions by processor; SLEEF's "cinz" functions are bit-identical everywhere
// (Shibata and Petrogalli, "SLEEF: A Portable Vectorized Library of C Standard Mathematical Functions", 2020), within 1
// ulp. The rest is IEEE arithmetic, which -ffp-contract=off keeps unfused. This file asserts the other demands on the
// compiler; sh/arithmetic.h checks the running process.
#pragma once

#include <sleef.h>

#include <cfloat>
#include <cmath>
#include <limits>

#if defined(__aarch64__)
#include <arm_neon.h>
#else
#include <emmintrin.h>
#endif

#include "shared.h"

#define INLINE inline
#define CONSTANT inline constexpr
#define NUMBER(literal) Number(literal)
#define SCALED(factor, value) ((factor) != Number(0) ? (factor) * (value) : Number(0))

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "Baked bytes need IEEE arithmetic: no option that relaxes it"
#endif
static_assert(FLT_EVAL_METHOD == 0, "baked bytes need arithmetic in the operands' own precision: SSE2, not the x87");
static_assert(std::numeric_limits<float>::is_iec559 && std::numeric_limits<double>::is_iec559 &&
                  std::numeric_limits<double>::digits == 53,
              "baked bytes need IEEE single and double precision");

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

/// Two numbers side by side. + - * / act on both, and give the same bits as they do on each number alone.
#if defined(__aarch64__)
using Number2 = float64x2_t;
inline Number2 sqrt(Number2 x) {
  return vsqrtq_f64(x);
}
inline Number2 atan(Number2 y, Number2 x) {
  return Sleef_cinz_atan2d2_u10advsimdnofma(y, x);
}
#else
using Number2 = __m128d;
inline Number2 sqrt(Number2 x) {
  return _mm_sqrt_pd(x);
}
inline Number2 atan(Number2 y, Number2 x) {
  return Sleef_cinz_atan2d2_u10sse2(y, x);
}
#endif
}  // namespace welkin::det

#undef SCALED
#undef NUMBER
#undef CONSTANT
#undef INLINE
