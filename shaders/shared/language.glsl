// SPDX-License-Identifier: Apache-2.0
// Definitions that let the files of this folder compile as GLSL. language.h does the same for C++.
#ifndef WELKIN_SHARED_LANGUAGE_GLSL
#define WELKIN_SHARED_LANGUAGE_GLSL

#define INLINE
#define CONSTANT const
#define NUMBER(literal) literal
// factor * value. C++ skips the value where the factor is 0; a shader computes it to avoid a branch.
#define SCALED(factor, value) ((factor) * (value))
#define Number float
#define Number3 vec3

// exp(x) - 1 without cancellation near 0 (C++ has it as a library function).
// Degree-7 Taylor polynomial for |x| < 0.5: truncation below 2e-7 of the result.
float expMinusOne(float x) {
  if (abs(x) >= 0.5) return exp(x) - 1.0;
  return x * (1.0 + x * (1.0 / 2.0 + x * (1.0 / 6.0 + x * (1.0 / 24.0 + x * (1.0 / 120.0 + x * (1.0 / 720.0 +
         x * (1.0 / 5040.0)))))));
}

#endif
