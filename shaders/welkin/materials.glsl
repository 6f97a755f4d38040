// SPDX-License-Identifier: Apache-2.0
// Includes the shared formulas of materials into a shader, at most once.
#ifndef WELKIN_MATERIALS_GLSL
#define WELKIN_MATERIALS_GLSL
#include "formulas.glsl"
#include "../shared/materials.glsl"
#endif
