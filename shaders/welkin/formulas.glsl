// SPDX-License-Identifier: Apache-2.0
// Includes the shared formulas into a shader, at most once.
#ifndef WELKIN_FORMULAS_GLSL
#define WELKIN_FORMULAS_GLSL
#include "../shared/language.glsl"
#include "../shared/formulas.glsl"
#endif
