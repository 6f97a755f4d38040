// SPDX-License-Identifier: Apache-2.0
// Declares the uniform block `level` and shared definitions of the level picture's passes. Set 0 is the sky's, set 1
// the level's.
#ifndef WELKIN_LEVEL_GLSL
#define WELKIN_LEVEL_GLSL

#define WELKIN_SET 0
#define WELKIN_LEVEL_SET 1
#include "welkin/sky_bindings.h"
#include "welkin/formulas.glsl"
#include "level_formulas.glsl"
#include "level_constants.h"

layout(set = WELKIN_LEVEL_SET, binding = WELKIN_LEVEL_CONSTANTS, std140) uniform LevelBlock { LevelConstants level; };

#endif
