// SPDX-License-Identifier: Apache-2.0
// All shared formulas in the order of their dependence. C++ includes this file once for each scalar type.
#include "constants.glsl"
#include "colour.glsl"
#include "direction.glsl"
#include "light.glsl"
#include "luminance.glsl"
#include "gradient.glsl"
#include "disc.glsl"
#include "stars.glsl"
#include "sh.glsl"
#include "modes.glsl"
#include "transfer_basis.glsl"
