// SPDX-License-Identifier: Apache-2.0
// The shared formulas of materials in double with the same bits on every machine, beside sh/deterministic.h's.
#pragma once

#include "sh/deterministic.h"

#define INLINE inline
#define CONSTANT inline constexpr
#define NUMBER(literal) Number(literal)

namespace welkin::det {
#include "materials.glsl"  // NOLINT(bugprone-suspicious-include)
}  // namespace welkin::det

#undef NUMBER
#undef CONSTANT
#undef INLINE
