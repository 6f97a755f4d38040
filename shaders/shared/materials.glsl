// SPDX-License-Identifier: Apache-2.0
// All shared formulas of materials, in the order of their dependence. C++ includes materials.h or, for numbers in files,
// sh/deterministic_materials.h; a shader includes welkin/materials.glsl.
#include "gloss.glsl"
#include "specular.glsl"
#include "wrapped.glsl"
#include "reflection.glsl"
#include "reflection_lobe.glsl"
