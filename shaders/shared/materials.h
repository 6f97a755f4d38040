// SPDX-License-Identifier: Apache-2.0
// The shared formulas of materials as C++, twice, as shared.h has the others: welkin::f64 is the reference and
// welkin::f32 stands for the GPU. Numbers in files use sh/deterministic_materials.h instead.
#pragma once

#include "shared.h"

#define INLINE inline
#define CONSTANT inline constexpr
#define NUMBER(literal) Number(literal)

// NOLINTBEGIN(bugprone-suspicious-include)
namespace welkin::f64 {
inline Number log(Number x) {
  return std::log(x);
}
#include "materials.glsl"
}  // namespace welkin::f64

namespace welkin::f32 {
inline Number log(Number x) {
  return std::log(x);
}
#include "materials.glsl"
}  // namespace welkin::f32
// NOLINTEND(bugprone-suspicious-include)

#undef NUMBER
#undef CONSTANT
#undef INLINE
