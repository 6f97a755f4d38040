// SPDX-License-Identifier: Apache-2.0
// The formulas of the level picture as C++, in double, beside the shared ones.
#pragma once

#include "shared.h"

#define INLINE inline
#define CONSTANT inline constexpr
#define NUMBER(literal) Number(literal)
namespace welkin::shaders {
using namespace f64;
#include "render/shaders/level_formulas.glsl"  // NOLINT(bugprone-suspicious-include)
}  // namespace welkin::shaders
#undef NUMBER
#undef CONSTANT
#undef INLINE
